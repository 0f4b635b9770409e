// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>

namespace driver {

/// Winding number of a triangle in the plane about p: 1 counter-clockwise, -1 clockwise, 0 outside. It is
/// exact for p moved by an infinitely small step along x. So a point on an edge or a node belongs to the
/// triangles on one side of it only, and a line enters a closed surface as often as it leaves.
int winding_about(const std::array<Eigen::Vector2d, 3>& corner, const Eigen::Vector2d& p);

}  // namespace driver
