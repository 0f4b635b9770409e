// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <Eigen/Core>

namespace coupling::detail {

// Distance [m] of the origin from the closed triangle with these columns as corners. One without area counts
// as its edges.
double distance_from_origin(const Eigen::Matrix3d& corners);

// True if the origin's projection on the plane is strictly inside the triangle with this normal, of any
// length.
bool foot_inside(const Eigen::Matrix3d& corners, const Eigen::Vector3d& normal);

}  // namespace coupling::detail
