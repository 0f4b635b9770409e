// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

/// Numbers that carry their derivatives by all unknowns of a tank: the exact Jacobian of its rates.
namespace random_tanks {

inline constexpr std::size_t kMostUnknowns = 7;

struct Dual {
  double value = 0.0;
  std::array<double, kMostUnknowns> slope{};

  Dual() = default;
  Dual(double number) : value(number) {}  // NOLINT: a constant is a number, too

  /// f(this), of which f and f' are given.
  Dual mapped(double f, double derivative) const {
    Dual result(f);
    for (std::size_t i = 0; i < kMostUnknowns; ++i) result.slope[i] = derivative * slope[i];
    return result;
  }
  Dual& operator+=(const Dual& b) {
    value += b.value;
    for (std::size_t i = 0; i < kMostUnknowns; ++i) slope[i] += b.slope[i];
    return *this;
  }
  Dual& operator-=(const Dual& b) {
    value -= b.value;
    for (std::size_t i = 0; i < kMostUnknowns; ++i) slope[i] -= b.slope[i];
    return *this;
  }
};

inline Dual operator+(Dual a, const Dual& b) {
  return a += b;
}
inline Dual operator-(Dual a, const Dual& b) {
  return a -= b;
}
inline Dual operator-(const Dual& a) {
  return a.mapped(-a.value, -1.0);
}
inline Dual operator*(const Dual& a, const Dual& b) {
  Dual result(a.value * b.value);
  for (std::size_t i = 0; i < kMostUnknowns; ++i)
    result.slope[i] = a.slope[i] * b.value + a.value * b.slope[i];
  return result;
}
inline Dual operator/(const Dual& a, const Dual& b) {
  return a * b.mapped(1.0 / b.value, -1.0 / (b.value * b.value));
}

inline Dual sqrt(const Dual& a) {
  const double root = std::sqrt(a.value);
  return a.mapped(root, 0.5 / root);
}
inline Dual exp(const Dual& a) {
  return a.mapped(std::exp(a.value), std::exp(a.value));
}
inline Dual expm1(const Dual& a) {
  return a.mapped(std::expm1(a.value), std::exp(a.value));
}
inline Dual log(const Dual& a) {
  return a.mapped(std::log(a.value), 1.0 / a.value);
}
inline Dual log1p(const Dual& a) {
  return a.mapped(std::log1p(a.value), 1.0 / (1.0 + a.value));
}

inline double value_of(double a) {
  return a;
}
inline double value_of(const Dual& a) {
  return a.value;
}

}  // namespace random_tanks
