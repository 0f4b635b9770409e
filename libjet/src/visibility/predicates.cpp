// SPDX-License-Identifier: Apache-2.0
// This file is compiled with -frounding-math -ftrapping-math (see CMakeLists.txt): CGAL's interval filter
// switches the rounding direction, and the compiler must take that into account.
#include "visibility/predicates.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>

namespace jet::exact {
namespace {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = CgalKernel::Point_3;
using Rational = CGAL::Exact_rational;

Point point(const double* p) {
  return {p[0], p[1], p[2]};
}

struct RationalVector {
  Rational x, y, z;
};

RationalVector difference(const double* q, const double* p) {
  return {Rational(q[0]) - Rational(p[0]), Rational(q[1]) - Rational(p[1]), Rational(q[2]) - Rational(p[2])};
}

RationalVector vector(const double* d) {
  return {Rational(d[0]), Rational(d[1]), Rational(d[2])};
}

RationalVector cross(const RationalVector& u, const RationalVector& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

Rational dot(const RationalVector& u, const RationalVector& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}

}  // namespace

int orientation(const double* p, const double* q, const double* r, const double* s) {
  return static_cast<int>(CGAL::orientation(point(p), point(q), point(r), point(s)));
}

int slope(const double* d, const double* p, const double* q, const double* r) {
  return static_cast<int>(CGAL::sign(dot(vector(d), cross(difference(q, p), difference(r, p)))));
}

bool collinear(const double* a, const double* b, const double* c) {
  return CGAL::collinear(point(a), point(b), point(c));
}

bool on_triangle(const double* s, const double* a, const double* b, const double* c) {
  const Point ps = point(s), pa = point(a), pb = point(b), pc = point(c);
  if (CGAL::collinear(pa, pb, pc) || CGAL::orientation(ps, pa, pb, pc) != CGAL::ZERO) return false;
  return CGAL::coplanar_orientation(pa, pb, pc, ps) != CGAL::NEGATIVE &&
         CGAL::coplanar_orientation(pb, pc, pa, ps) != CGAL::NEGATIVE &&
         CGAL::coplanar_orientation(pc, pa, pb, ps) != CGAL::NEGATIVE;
}

bool stays_on_triangle(const double* s, const double* d, const double* a, const double* b, const double* c) {
  if (!on_triangle(s, a, b, c)) return false;
  const RationalVector normal = cross(difference(b, a), difference(c, a));
  const auto leaves_over = [&](const double* p, const double* q) {
    return collinear(p, q, s) && dot(normal, cross(difference(q, p), vector(d))) < 0;
  };
  return !leaves_over(a, b) && !leaves_over(b, c) && !leaves_over(c, a);
}

}  // namespace jet::exact
