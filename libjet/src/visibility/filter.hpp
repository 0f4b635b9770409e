// SPDX-License-Identifier: Apache-2.0
// Predicates in double with an error bound. Exact arithmetic decides the other signs. Bound: Shewchuk,
// Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997. The determinant of
// differences errs by at most (7 + 56 u) u times its permanent, u = 2^-53. The permanent is at most 6 max|dx|
// max|dy| max|dz|. The product 4.66e-15 is rounded up for the roundings of the bound itself. kUnderflow
// covers products below the normal range: coordinates are at most 1e100, so these losses stay below 1e-220.
#pragma once

#include <algorithm>
#include <cmath>

#include "visibility/predicates.hpp"

namespace jet::filter {

inline constexpr double kRelative = 5.2e-15;
inline constexpr double kUnderflow = 1e-200;

inline double max3(double a, double b, double c) {
  return std::max(std::max(a, b), c);
}

/// Sign of a value with the error bound `error`; 2 if the sign is not certain.
inline int certain_sign(double value, double error) {
  return value > error ? 1 : value < -error ? -1 : 2;
}

inline int orientation(const double* p, const double* q, const double* r, const double* s) {
  const double qx = q[0] - p[0], qy = q[1] - p[1], qz = q[2] - p[2];
  const double rx = r[0] - p[0], ry = r[1] - p[1], rz = r[2] - p[2];
  const double sx = s[0] - p[0], sy = s[1] - p[1], sz = s[2] - p[2];
  const double x = max3(std::abs(qx), std::abs(rx), std::abs(sx));
  const double y = max3(std::abs(qy), std::abs(ry), std::abs(sy));
  const double z = max3(std::abs(qz), std::abs(rz), std::abs(sz));
  // A difference is exactly zero if the coordinates are equal, so points in a coordinate plane need no exact
  // call.
  if (x == 0.0 || y == 0.0 || z == 0.0) return 0;
  const double value = qx * (ry * sz - rz * sy) + qy * (rz * sx - rx * sz) + qz * (rx * sy - ry * sx);
  return certain_sign(value, kRelative * x * y * z + kUnderflow);
}

/// d is exact here, not a difference, so the bound of `orientation` is more than enough.
inline int slope(const double* d, const double* p, const double* q, const double* r) {
  const double zero[3] = {0.0, 0.0, 0.0};
  const double u[3] = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  const double v[3] = {r[0] - p[0], r[1] - p[1], r[2] - p[2]};
  return orientation(zero, d, u, v);
}

/// Kernel for the shared rule, see blocking.hpp. Counts the predicates that needed exact arithmetic.
struct Kernel {
  std::size_t calls = 0;

  int orientation(const double* p, const double* q, const double* r, const double* s) {
    const int sign = filter::orientation(p, q, r, s);
    if (sign != 2) return sign;
    ++calls;
    return exact::orientation(p, q, r, s);
  }
  int slope(const double* d, const double* p, const double* q, const double* r) {
    const int sign = filter::slope(d, p, q, r);
    if (sign != 2) return sign;
    ++calls;
    return exact::slope(d, p, q, r);
  }
  bool on_triangle(const double* s, const double* a, const double* b, const double* c) {
    return orientation(s, a, b, c) == 0 && exact::on_triangle(s, a, b, c);
  }
};

}  // namespace jet::filter
