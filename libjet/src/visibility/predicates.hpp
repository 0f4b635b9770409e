// SPDX-License-Identifier: Apache-2.0
// Exact predicates on points given as three doubles. CGAL is included in source files only.
#pragma once

#include <cstddef>

namespace jet::exact {

/// Sign of det(q - p, r - p, s - p): CGAL's orientation.
int orientation(const double* p, const double* q, const double* r, const double* s);

/// Sign of d . ((q - p) x (r - p)) for a vector d given as three doubles.
int slope(const double* d, const double* p, const double* q, const double* r);

/// True if point s is on the closed triangle (a, b, c), which has an area.
bool on_triangle(const double* s, const double* a, const double* b, const double* c);

/// True if s and s + eps d, eps -> 0+, are both on that triangle. Precondition: d is parallel to its plane.
bool stays_on_triangle(const double* s, const double* d, const double* a, const double* b, const double* c);

/// True if the three points lie on one line.
bool collinear(const double* a, const double* b, const double* c);

/// Kernel of the reference routes: predicates by CGAL alone, and their count.
struct Kernel {
  std::size_t calls = 0;

  int orientation(const double* p, const double* q, const double* r, const double* s) {
    ++calls;
    return exact::orientation(p, q, r, s);
  }
  int slope(const double* d, const double* p, const double* q, const double* r) {
    ++calls;
    return exact::slope(d, p, q, r);
  }
  template <class Ray>
  bool moved(const Ray& ray) const {
    return ray.moved == decltype(ray.moved)::yes;
  }
  bool on_triangle(const double* s, const double* a, const double* b, const double* c) {
    return orientation(s, a, b, c) == 0 && exact::on_triangle(s, a, b, c);
  }
};

}  // namespace jet::exact
