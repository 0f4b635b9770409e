// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jet/jet.hpp"
#include "kernel_table.hpp"

namespace jet {

/// A validated model in the form that the formulas read, without the cut-off.
JetShape outline(const JetModel& model);

}  // namespace jet
