// SPDX-License-Identifier: Apache-2.0
// Checks of the input of a visibility query, which throw std::invalid_argument.
#pragma once

#include <string>

#include "jet/visibility.hpp"
#include "visibility/surface.hpp"

namespace jet {

inline constexpr double kLargest = 1e100;  // magnitude of a coordinate

[[noreturn]] void refuse(const std::string& message);

void require_index(const char* name, int index, int count);

void check_source(const RaySource& source);

/// Largest magnitude of a coordinate of the nodes; throws std::invalid_argument if one is out of range.
double check_nodes(const Surface& surface);

}  // namespace jet
