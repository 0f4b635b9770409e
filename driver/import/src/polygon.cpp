// SPDX-License-Identifier: Apache-2.0
// Triangles of polygons by ears.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "import/bag_surface.hpp"

namespace driver::imported {
namespace {

using Point = Eigen::Vector2d;

double cross(const Point& a, const Point& b, const Point& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// The corners in the plane across their Newell normal, counter-clockwise.
std::vector<Point> in_plane(const std::vector<Eigen::Vector3d>& corners) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  const Eigen::Vector3d& origin = corners.front();
  for (std::size_t i = 0; i < corners.size(); ++i)
    normal += (corners[i] - origin).cross(corners[(i + 1) % corners.size()] - origin);
  const double size = normal.norm();
  if (!(size > 0.0)) return {};
  normal /= size;
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  std::vector<Point> points;
  for (const auto& corner : corners) points.emplace_back((corner - origin).dot(u), (corner - origin).dot(v));
  return points;
}

// Sine of the smallest angle of a triangle, below zero if it is turned.
double shape_of(const Point& a, const Point& b, const Point& c) {
  const double twice = cross(a, b, c);
  const double ab = (b - a).norm(), bc = (c - b).norm(), ca = (a - c).norm();
  const double largest = std::max({ab * bc, bc * ca, ca * ab});
  return largest > 0.0 ? twice / largest : -1.0;
}

// True for a point in the triangle or on its sides, as close as nodes lie on edges of larger elements.
bool holds(const Point& a, const Point& b, const Point& c, const Point& p) {
  constexpr double near = 2e-3;  // of a side
  const auto inside = [&](const Point& from, const Point& to) {
    return cross(from, to, p) >= -near * (to - from).squaredNorm();
  };
  return inside(a, b) && inside(b, c) && inside(c, a);
}

// Ears with angles whose sine is above `flat`; empty if that does not work out.
std::vector<std::array<int, 3>> ears_of(const std::vector<Point>& points, double flat) {
  std::vector<int> left(points.size());
  std::iota(left.begin(), left.end(), 0);
  const auto at = [&](std::size_t i) -> const Point& {
    return points[static_cast<std::size_t>(left[i % left.size()])];
  };
  const auto is_ear = [&](std::size_t i) {
    const std::size_t n = left.size();
    for (std::size_t j = 0; j < n; ++j)
      if (j != i % n && j != (i + 1) % n && j != (i + n - 1) % n &&
          holds(at(i + n - 1), at(i), at(i + 1), at(j)))
        return false;
    return true;
  };
  std::vector<std::array<int, 3>> triangles;
  while (left.size() > 3) {
    std::size_t best = left.size();
    double best_shape = flat;
    for (std::size_t i = 0; i < left.size(); ++i) {
      const double shape = shape_of(at(i + left.size() - 1), at(i), at(i + 1));
      if (shape > best_shape && is_ear(i)) {
        best = i;
        best_shape = shape;
      }
    }
    if (best == left.size()) return {};
    const std::size_t n = left.size();
    triangles.push_back({left[(best + n - 1) % n], left[best], left[(best + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
  }
  if (shape_of(at(0), at(1), at(2)) <= flat) return {};
  triangles.push_back({left[0], left[1], left[2]});
  return triangles;
}

}  // namespace

std::vector<std::array<int, 3>> triangles_of(const std::vector<Eigen::Vector3d>& corners) {
  const auto points = in_plane(corners);
  if (points.size() < 3) return {};
  for (const double flat : {0.05, 1e-3, 1e-6})
    if (auto triangles = ears_of(points, flat); !triangles.empty()) return triangles;
  return {};
}

}  // namespace driver::imported
