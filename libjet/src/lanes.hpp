// SPDX-License-Identifier: Apache-2.0
// Four double lanes on the compiler's vector extension. There are always four, so that every instruction set
// gives the same bits. The type is in the namespace of its instruction set: so templates over it differ
// between translation units, and the linker cannot mix them up. For the same reason this file uses nothing
// inline of the standard library.
#pragma once

#include <cstddef>
#include <cstdint>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "kernel_table.hpp"

namespace jet::JET_KERNELS {

struct Lanes {
  using Values = double __attribute__((vector_size(32)));
  typedef double Unaligned __attribute__((vector_size(32), aligned(8), may_alias));
  static_assert(alignof(Unaligned) == 8);  // clang aligns an alias by `using` to 32
  using Mask = std::int64_t __attribute__((vector_size(32)));
  Values v{};

  Lanes() = default;
  explicit Lanes(double x) : v{x, x, x, x} {}
  explicit Lanes(Values x) : v(x) {}
  static Lanes load(const double* p) { return Lanes(*reinterpret_cast<const Unaligned*>(p)); }
  double operator[](int lane) const { return v[lane]; }

  friend Lanes operator+(Lanes a, Lanes b) { return Lanes(a.v + b.v); }
  friend Lanes operator-(Lanes a, Lanes b) { return Lanes(a.v - b.v); }
  friend Lanes operator*(Lanes a, Lanes b) { return Lanes(a.v * b.v); }
  friend Lanes operator/(Lanes a, Lanes b) { return Lanes(a.v / b.v); }
  friend Lanes operator+(double a, Lanes b) { return Lanes(a + b.v); }
  friend Lanes operator-(Lanes a, double b) { return Lanes(a.v - b); }
  friend Lanes operator*(double a, Lanes b) { return Lanes(a * b.v); }
  friend Lanes operator/(double a, Lanes b) { return Lanes(a / b.v); }
  friend Lanes operator/(Lanes a, double b) { return Lanes(a.v / b); }
  friend Lanes operator-(Lanes a) { return Lanes(-a.v); }
  friend Mask operator<(Lanes a, Lanes b) { return a.v < b.v; }
  friend Mask operator>(Lanes a, Lanes b) { return a.v > b.v; }
  friend Mask operator<=(Lanes a, Lanes b) { return a.v <= b.v; }
  friend Lanes select(Mask m, Lanes a, Lanes b) { return Lanes(m ? a.v : b.v); }
  friend Lanes min(Lanes a, Lanes b) { return select(b < a, b, a); }
  friend Lanes max(Lanes a, Lanes b) { return select(a < b, b, a); }
  friend Lanes abs(Lanes a) {
    return Lanes(reinterpret_cast<Values>(reinterpret_cast<Mask>(a.v) & INT64_MAX));
  }
  friend Lanes sqrt(Lanes a) {
#if defined(__AVX__)
    return Lanes(reinterpret_cast<Values>(_mm256_sqrt_pd(reinterpret_cast<__m256d>(a.v))));
#else
    return Lanes(Values{__builtin_sqrt(a.v[0]), __builtin_sqrt(a.v[1]), __builtin_sqrt(a.v[2]),
                        __builtin_sqrt(a.v[3])});
#endif
  }
};

/// One bit for each lane.
inline unsigned bits(Lanes::Mask m) {
#if defined(__AVX__)
  return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(m)));
#else
  return static_cast<unsigned>((m[0] & 1) | (m[1] & 2) | (m[2] & 4) | (m[3] & 8));
#endif
}

[[gnu::always_inline]] inline double least(Lanes a) {
  a = min(a, Lanes(__builtin_shufflevector(a.v, a.v, 2, 3, 0, 1)));
  return min(a, Lanes(__builtin_shufflevector(a.v, a.v, 1, 0, 3, 2))).v[0];
}

/// e^x for x <= 0, within 2 roundings; 0 below -708. Cody and Waite's reduction to |r| <= ln(2)/2, where
/// Taylor's polynomial of degree 13 has a remainder of 5e-18.
inline Lanes exp(Lanes x) {
  constexpr double log2_e = 1.4426950408889634, shift = 0x1.8p52;
  constexpr double ln2_high = 0x1.62e42fefa3800p-1,
                   ln2_low = 0x1.ef35793c76730p-45;  // the high part ends with 11 zeros
  const Lanes inside = max(x, Lanes(-709.0));
  const Lanes shifted = Lanes(shift) + log2_e * inside;  // n in the low bits
  const Lanes n = shifted - shift;
  const Lanes r = (inside - ln2_high * n) - ln2_low * n;
  // Sums x^k / k! by pairs and pairs of pairs, which keeps the chains of operations short.
  const auto pair = [&](double even, double odd) { return odd * r + Lanes(even); };
  const Lanes r2 = r * r, r4 = r2 * r2;
  const Lanes low = pair(1.0 / 24.0, 1.0 / 120.0) + r2 * pair(1.0 / 720.0, 1.0 / 5040.0);
  const Lanes high = (pair(1.0 / 40320.0, 1.0 / 362880.0) + r2 * pair(1.0 / 3628800.0, 1.0 / 39916800.0)) +
                     r4 * pair(1.0 / 479001600.0, 1.0 / 6227020800.0);
  const Lanes cubic = r2 * pair(0.5, 1.0 / 6.0);
  const Lanes sum = Lanes(1.0) + (r + (cubic + r4 * (low + r4 * high)));
  const auto exponent = (reinterpret_cast<Lanes::Mask>(shifted.v) + 1023)
                        << 52;  // the shift's own bits fall off
  return select(x < Lanes(-708.0), Lanes(), sum * Lanes(reinterpret_cast<Lanes::Values>(exponent)));
}

/// Row i: four doubles, three of them used.
[[gnu::always_inline]] inline const double* row(const Rows& rows, int i) {
  return i == rows.last ? rows.tail : rows.first + i * rows.stride;
}

/// Gathers four rows into lanes of x, y and z.
[[gnu::always_inline]] inline Vec3<Lanes> gather(const double* a, const double* b, const double* c,
                                                 const double* d) {
  const auto p = Lanes::load(a).v, q = Lanes::load(b).v, r = Lanes::load(c).v, s = Lanes::load(d).v;
  const auto xz_01 = __builtin_shufflevector(p, q, 0, 4, 2, 6);
  const auto xz_23 = __builtin_shufflevector(r, s, 0, 4, 2, 6);
  const auto y_01 = __builtin_shufflevector(p, q, 1, 5, 3, 7);
  const auto y_23 = __builtin_shufflevector(r, s, 1, 5, 3, 7);
  return {Lanes(__builtin_shufflevector(xz_01, xz_23, 0, 1, 4, 5)),
          Lanes(__builtin_shufflevector(y_01, y_23, 0, 1, 4, 5)),
          Lanes(__builtin_shufflevector(xz_01, xz_23, 2, 3, 6, 7))};
}

}  // namespace jet::JET_KERNELS
