// SPDX-License-Identifier: Apache-2.0
// Whether an outlet is inside its bag.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "engine/scene.hpp"

namespace driver {

/// Throws std::invalid_argument for an outlet that is not inside the bag, nor flat on its skin with the axis
/// inwards; the message says where along its axis it would be. The rim of an outlet, not its source, may be
/// outside where the bag is thinner than the outlet is wide and its skin runs along the axis on both sides,
/// at 30 degrees at most: so is a jet in the plane of a flat bag. Returns the bag's thickness there [m], none
/// if the outlet is inside.
std::optional<double> require_outlet_inside(const jet::JetModel& model, const BagPart& bag);
/// The same for the centre of an outlet that moves with its module.
void require_centre_inside(const jet::JetModel& model, const Eigen::Matrix3Xi& elements,
                           const Eigen::Matrix3Xd& nodes);

}  // namespace driver
