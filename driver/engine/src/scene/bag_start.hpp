// SPDX-License-Identifier: Apache-2.0
// What is wrong with a bag's shape at the start: energy out of nothing.
#pragma once

#include "base/case_reader.hpp"
#include "engine/scene.hpp"

namespace driver {

/// Refuses a bag that is behind its plate, or reaches into it. `table` is [membrane].
void require_before_plates(const TableReader& table, const BagPart& bag);

/// Warns of fabric that is strained at the start by more than a thousandth of the scene's energy. Needs the
/// scene's gas and times.
void warn_of_strained_start(Scene& scene);

}  // namespace driver
