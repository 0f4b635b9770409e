// SPDX-License-Identifier: Apache-2.0
// Array views in the interface of the jet library.
#pragma once

#include <Eigen/Core>
#include <limits>

namespace jet {

/// 3 x n points or vectors, one a column. Any outer stride is accepted, so a padded 4 x n array needs no
/// copy.
using Points = Eigen::Ref<const Eigen::Matrix3Xd, 0, Eigen::OuterStride<>>;

/// 3 x M node indices from 0, one element a column. Closed surfaces are wound counter-clockwise seen from
/// outside.
using Triangles = Eigen::Ref<const Eigen::Matrix3Xi, 0, Eigen::OuterStride<>>;

/// Displacement bound of a caller that does not know how far the points have moved.
inline constexpr double kMotionUnknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace jet
