// SPDX-License-Identifier: Apache-2.0
#include "distances.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace coupling::detail {
namespace {

using Eigen::Vector3d;

// Squared distance of the origin from the segment a + t (b - a).
double squared_distance_to_segment(const Vector3d& a, const Vector3d& b) {
  const Vector3d edge = b - a;
  const double length2 = edge.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp(-a.dot(edge) / length2, 0.0, 1.0) : 0.0;
  return (a + t * edge).squaredNorm();
}

}  // namespace

bool foot_inside(const Eigen::Matrix3d& u, const Vector3d& n) {
  for (int i = 0; i < 3; ++i) {
    const Vector3d a = u.col(i), b = u.col((i + 1) % 3);
    if (!(n.dot(a.cross(b)) > 0.0)) return false;
  }
  return true;
}

double distance_from_origin(const Eigen::Matrix3d& u) {
  const Vector3d n = (u.col(1) - u.col(0)).cross(u.col(2) - u.col(0));
  if (foot_inside(u, n)) return std::abs(n.dot(u.col(0))) / n.norm();
  double squared = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
    squared = std::min(squared, squared_distance_to_segment(u.col(i), u.col((i + 1) % 3)));
  return std::sqrt(squared);
}

}  // namespace coupling::detail
