// SPDX-License-Identifier: Apache-2.0
// Plain array views that cross the border of the jet library.
#pragma once

#include <Eigen/Core>
#include <limits>

namespace jet {

/// 3 x n columns of doubles (points, vectors); an outer stride is accepted, so a 4 x n padded array needs no
/// copy.
using Points = Eigen::Ref<const Eigen::Matrix3Xd, 0, Eigen::OuterStride<>>;

/// 3 x M node indices from 0, one column an element. Closed surfaces are wound counter-clockwise seen from
/// outside.
using Triangles = Eigen::Ref<const Eigen::Matrix3Xi, 0, Eigen::OuterStride<>>;

/// Nobody says how far the points of a surface have moved.
inline constexpr double kMotionUnknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace jet
