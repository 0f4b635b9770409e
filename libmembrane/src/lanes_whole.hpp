// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <immintrin.h>

#include <cstdint>

// Lanes in one 32-byte register. Included by lanes.hpp.
namespace membrane::MEMBRANE_KERNELS {

struct Lanes {
  using Values = double __attribute__((vector_size(32)));
  using Mask = std::int64_t __attribute__((vector_size(32)));
  Values v{};

  Lanes() = default;
  explicit Lanes(double x) : v{x, x, x, x} {}
  explicit Lanes(Values x) : v(x) {}
  static Lanes load(const double* p) { return Lanes(*reinterpret_cast<const Values*>(p)); }
  void store(double* p) const { *reinterpret_cast<Values*>(p) = v; }
  double operator[](int lane) const { return v[lane]; }

  friend Lanes operator+(Lanes a, Lanes b) { return Lanes(a.v + b.v); }
  friend Lanes operator-(Lanes a, Lanes b) { return Lanes(a.v - b.v); }
  friend Lanes operator*(Lanes a, Lanes b) { return Lanes(a.v * b.v); }
  friend Lanes operator/(Lanes a, Lanes b) { return Lanes(a.v / b.v); }
  friend Lanes operator-(Lanes a) { return Lanes(-a.v); }
  friend Mask operator<(Lanes a, Lanes b) { return a.v < b.v; }
  friend Mask operator>(Lanes a, Lanes b) { return a.v > b.v; }
  friend Lanes select(Mask m, Lanes a, Lanes b) { return Lanes(m ? a.v : b.v); }
  friend bool any_positive(Lanes a) {
    return _mm256_movemask_pd(reinterpret_cast<__m256d>(a.v > Values{})) != 0;
  }
  friend Lanes sqrt(Lanes a) {
    return Lanes(reinterpret_cast<Values>(_mm256_sqrt_pd(reinterpret_cast<__m256d>(a.v))));
  }
};

// Rows (x, y, z, 0) of four vectors to lanes of x, y and z.
inline void to_lanes(const Lanes (&row)[4], Lanes& x, Lanes& y, Lanes& z) {
  const auto xz_01 = __builtin_shufflevector(row[0].v, row[1].v, 0, 4, 2, 6);
  const auto xz_23 = __builtin_shufflevector(row[2].v, row[3].v, 0, 4, 2, 6);
  const auto y_01 = __builtin_shufflevector(row[0].v, row[1].v, 1, 5, 3, 7);
  const auto y_23 = __builtin_shufflevector(row[2].v, row[3].v, 1, 5, 3, 7);
  x = Lanes(__builtin_shufflevector(xz_01, xz_23, 0, 1, 4, 5));
  y = Lanes(__builtin_shufflevector(y_01, y_23, 0, 1, 4, 5));
  z = Lanes(__builtin_shufflevector(xz_01, xz_23, 2, 3, 6, 7));
}

// Lanes of x, y and z to rows (x, y, z, 0) of four vectors.
inline void to_rows(const Lanes& x, const Lanes& y, const Lanes& z, Lanes (&row)[4]) {
  const Lanes zero;
  const auto xy_02 = __builtin_shufflevector(x.v, y.v, 0, 4, 2, 6);
  const auto xy_13 = __builtin_shufflevector(x.v, y.v, 1, 5, 3, 7);
  const auto z_02 = __builtin_shufflevector(z.v, zero.v, 0, 4, 2, 6);
  const auto z_13 = __builtin_shufflevector(z.v, zero.v, 1, 5, 3, 7);
  row[0] = Lanes(__builtin_shufflevector(xy_02, z_02, 0, 1, 4, 5));
  row[1] = Lanes(__builtin_shufflevector(xy_13, z_13, 0, 1, 4, 5));
  row[2] = Lanes(__builtin_shufflevector(xy_02, z_02, 2, 3, 6, 7));
  row[3] = Lanes(__builtin_shufflevector(xy_13, z_13, 2, 3, 6, 7));
}

}  // namespace membrane::MEMBRANE_KERNELS
