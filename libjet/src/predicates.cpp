// SPDX-License-Identifier: Apache-2.0
// This file is compiled with -frounding-math -ftrapping-math (see CMakeLists.txt): CGAL's interval filter
// switches the rounding direction, which the compiler must not assume away.
#include "predicates.hpp"

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

}  // namespace

int orientation(const double* p, const double* q, const double* r, const double* s) {
  return static_cast<int>(CGAL::orientation(point(p), point(q), point(r), point(s)));
}

int slope(const double* d, const double* p, const double* q, const double* r) {
  const RationalVector u = difference(q, p);
  const RationalVector v = difference(r, p);
  const Rational determinant = Rational(d[0]) * (u.y * v.z - u.z * v.y) +
                               Rational(d[1]) * (u.z * v.x - u.x * v.z) +
                               Rational(d[2]) * (u.x * v.y - u.y * v.x);
  return static_cast<int>(CGAL::sign(determinant));
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

}  // namespace jet::exact
