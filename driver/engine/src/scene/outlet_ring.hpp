// SPDX-License-Identifier: Apache-2.0
// [inflator.jet.ring]: round holes on a circle.
#pragma once

#include <vector>

#include "base/case_reader.hpp"
#include "jet/jet.hpp"

namespace driver {

/// The jets of an outlet's table: `model` alone, or that at each hole of a ring about its centre and axis.
std::vector<jet::JetModel> read_ring(TableReader& outlet, const jet::JetModel& model);

}  // namespace driver
