// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>

namespace driver {

/// How often a triangle in the plane goes around p: 1 counter-clockwise, -1 clockwise, 0 not. It is exact for
/// p an infinitely small step along x from where it is. So of the triangles that meet in an edge or a node, a
/// point on it belongs to those on one side, and a line through a closed surface enters it as often as it
/// leaves.
int winding_about(const std::array<Eigen::Vector2d, 3>& corner, const Eigen::Vector2d& p);

}  // namespace driver
