// SPDX-License-Identifier: Apache-2.0
// Closest points of two parts of a skin. The weights sum to 1 on each part.
#pragma once
#include <Eigen/Core>

namespace coupling::detail {

/// Point of a triangle: weights of its corners.
struct TrianglePoint {
  double weight[3];
};

/// Point of the closed triangle abc that is closest to p; of one without area, a point of its edges. Source:
/// C. Ericson, Real-Time Collision Detection (2005), 5.1.5.
TrianglePoint closest_on_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                  const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// Parameter in [0, 1] of the point a + t (b - a) that is closest to p.
double closest_on_segment(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Parameters of two points a + s u, b + t v.
struct SegmentPoints {
  double s, t;
};

/// Closest points of the segments a + s u and b + t v, s and t in [0, 1]. Source: Ericson, 5.1.9.
SegmentPoints closest_of_segments(const Eigen::Vector3d& a, const Eigen::Vector3d& u,
                                  const Eigen::Vector3d& b, const Eigen::Vector3d& v);

}  // namespace coupling::detail
