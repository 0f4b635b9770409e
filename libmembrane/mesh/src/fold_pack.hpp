// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace mesh {

// True if a triangle is inclined by more than 60 degrees to the plane across the thin axis of a pack.
bool is_on_edge(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, int thin_axis);

}  // namespace mesh
