// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jet/jet.hpp"
#include "kernel_table.hpp"

namespace jet {

/// A validated model as the formulas read it, without the cut-off.
JetShape outline(const JetModel& model);

}  // namespace jet
