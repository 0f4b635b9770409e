// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

// Lanes in two 16-byte registers, for processors without longer ones; gcc would pass longer vectors through
// memory there. Included by lanes.hpp.
namespace membrane::MEMBRANE_KERNELS {

using Pair = double __attribute__((vector_size(16)));
using PairMask = std::int64_t __attribute__((vector_size(16)));

inline Pair low_pair(Pair a, Pair b) {
  return __builtin_shufflevector(a, b, 0, 2);
}
inline Pair high_pair(Pair a, Pair b) {
  return __builtin_shufflevector(a, b, 1, 3);
}

inline Pair sqrt_pair(Pair a) {
#if defined(__SSE2__)
  return reinterpret_cast<Pair>(_mm_sqrt_pd(reinterpret_cast<__m128d>(a)));
#else
  return Pair{__builtin_sqrt(a[0]), __builtin_sqrt(a[1])};
#endif
}

struct Lanes {
  struct Mask {
    PairMask low, high;
  };
  Pair low{}, high{};

  Lanes() = default;
  explicit Lanes(double x) : low{x, x}, high{x, x} {}
  Lanes(Pair l, Pair h) : low(l), high(h) {}
  static Lanes load(const double* p) {
    return {*reinterpret_cast<const Pair*>(p), *reinterpret_cast<const Pair*>(p + 2)};
  }
  void store(double* p) const {
    *reinterpret_cast<Pair*>(p) = low;
    *reinterpret_cast<Pair*>(p + 2) = high;
  }
  double operator[](int lane) const { return lane < 2 ? low[lane] : high[lane - 2]; }

  friend Lanes operator+(Lanes a, Lanes b) { return {a.low + b.low, a.high + b.high}; }
  friend Lanes operator-(Lanes a, Lanes b) { return {a.low - b.low, a.high - b.high}; }
  friend Lanes operator*(Lanes a, Lanes b) { return {a.low * b.low, a.high * b.high}; }
  friend Lanes operator/(Lanes a, Lanes b) { return {a.low / b.low, a.high / b.high}; }
  friend Lanes operator-(Lanes a) { return {-a.low, -a.high}; }
  friend Mask operator<(Lanes a, Lanes b) { return {a.low < b.low, a.high < b.high}; }
  friend Mask operator>(Lanes a, Lanes b) { return {a.low > b.low, a.high > b.high}; }
  friend Lanes select(Mask m, Lanes a, Lanes b) { return {m.low ? a.low : b.low, m.high ? a.high : b.high}; }
  friend bool any_positive(Lanes a) {
    const PairMask m = (a.low > Pair{}) | (a.high > Pair{});
    return (m[0] | m[1]) != 0;
  }
  friend Lanes sqrt(Lanes a) { return {sqrt_pair(a.low), sqrt_pair(a.high)}; }
};

// Rows (x, y, z, 0) of four vectors to lanes of x, y and z.
inline void to_lanes(const Lanes (&row)[4], Lanes& x, Lanes& y, Lanes& z) {
  x = {low_pair(row[0].low, row[1].low), low_pair(row[2].low, row[3].low)};
  y = {high_pair(row[0].low, row[1].low), high_pair(row[2].low, row[3].low)};
  z = {low_pair(row[0].high, row[1].high), low_pair(row[2].high, row[3].high)};
}

// Lanes of x, y and z to rows (x, y, z, 0) of four vectors.
inline void to_rows(const Lanes& x, const Lanes& y, const Lanes& z, Lanes (&row)[4]) {
  const Pair zero{};
  row[0] = {low_pair(x.low, y.low), low_pair(z.low, zero)};
  row[1] = {high_pair(x.low, y.low), high_pair(z.low, zero)};
  row[2] = {low_pair(x.high, y.high), low_pair(z.high, zero)};
  row[3] = {high_pair(x.high, y.high), high_pair(z.high, zero)};
}

}  // namespace membrane::MEMBRANE_KERNELS
