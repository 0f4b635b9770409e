// SPDX-License-Identifier: Apache-2.0
// [impactor] -> shape, and PendulumPart or BodyPart.
#pragma once

#include "engine/scene.hpp"

namespace driver {

/// Keys of a pendulum but for its impactor's radius, which is `radius` [m].
PendulumPart read_pendulum_motion(TableReader& table, double radius, const Eigen::Vector3d& gravity);

/// [impactor]
void read_impactor(TableReader& table, Scene& scene);

}  // namespace driver
