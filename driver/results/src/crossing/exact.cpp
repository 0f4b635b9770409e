// SPDX-License-Identifier: Apache-2.0
// This file is compiled with -frounding-math -ftrapping-math (see CMakeLists.txt): CGAL's interval filter
// switches the rounding direction, and the compiler must take that into account.
#include "crossing/exact.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace driver::exact {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 point(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

Kernel::Point_2 point(const Eigen::Vector2d& p) {
  return {p.x(), p.y()};
}

Kernel::Triangle_3 triangle(const Triangle& t) {
  return {point(t[0]), point(t[1]), point(t[2])};
}

}  // namespace

bool is_degenerate(const Triangle& t) {
  return CGAL::collinear(point(t[0]), point(t[1]), point(t[2]));
}

bool meet(const Triangle& t, const Triangle& u) {
  return CGAL::do_intersect(triangle(t), triangle(u));
}

bool meet(const Triangle& t, const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
  return CGAL::do_intersect(triangle(t), Kernel::Segment_3(point(p), point(q)));
}

bool overlap(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
             const Eigen::Vector3d& d) {
  return CGAL::coplanar(point(a), point(b), point(c), point(d)) &&
         CGAL::coplanar_orientation(point(a), point(b), point(c), point(d)) == CGAL::POSITIVE;
}

int side(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
  return static_cast<int>(CGAL::orientation(point(a), point(b), point(p)));
}

}  // namespace driver::exact
