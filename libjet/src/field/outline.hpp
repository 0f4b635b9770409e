// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jet/jet.hpp"
#include "kernel_table.hpp"

namespace jet {

/// Range of the restitution [-].
inline constexpr double kLeastRestitution = -0.5, kMostRestitution = 4.0;
inline constexpr const char* kRestitutionRange = "[-0.5, 4]";

/// A validated model in the form that the formulas read, without the cut-off.
JetShape outline(const JetModel& model);

}  // namespace jet
