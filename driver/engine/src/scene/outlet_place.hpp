// SPDX-License-Identifier: Apache-2.0
// Whether an outlet is inside its bag.
#pragma once

#include "engine/scene.hpp"

namespace driver {

/// Throws std::invalid_argument for an outlet that is not inside the bag, nor flat on its skin with the axis
/// inwards; the message says where along its axis it would be.
void require_outlet_inside(const jet::JetModel& model, const BagPart& bag);

}  // namespace driver
