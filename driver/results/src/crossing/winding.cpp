// SPDX-License-Identifier: Apache-2.0
#include "results/winding.hpp"

#include <cmath>

#include "crossing/exact.hpp"

namespace driver {
namespace {

using Point = Eigen::Vector2d;

// As exact::side. The two products are off by less than 4.1 roundings (2^-53) of the sum of their
// magnitudes.
int side(const Point& a, const Point& b, const Point& p) {
  constexpr double share = 4.1 * 0x1p-53, underflow = 1e-300;
  const double left = (b.x() - a.x()) * (p.y() - a.y()), right = (b.y() - a.y()) * (p.x() - a.x());
  const double value = left - right;
  if (std::abs(value) > share * (std::abs(left) + std::abs(right)) + underflow) return value > 0.0 ? 1 : -1;
  return exact::side(a, b, p);
}

// Crossings of the edge a b by the ray from p along x, upwards minus downwards, for p moved by an infinitely
// small step along x. So for all triangles at an edge or a node, p is on the same side of it.
int passes(const Point& a, const Point& b, const Point& p) {
  if (a.y() <= p.y() && b.y() > p.y()) return side(a, b, p) > 0 ? 1 : 0;
  if (b.y() <= p.y() && a.y() > p.y()) return side(a, b, p) < 0 ? -1 : 0;
  return 0;
}

}  // namespace

int winding_about(const std::array<Point, 3>& corner, const Point& p) {
  return passes(corner[0], corner[1], p) + passes(corner[1], corner[2], p) + passes(corner[2], corner[0], p);
}

}  // namespace driver
