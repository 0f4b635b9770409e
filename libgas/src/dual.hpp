// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <elementary/exponential.hpp>

namespace gas {

/// A number and its derivatives by N variables. (Boost's autodiff also computes all higher derivatives;
/// neither it nor Eigen's has log1p and expm1.)
template <std::size_t N>
struct Dual {
  double value = 0.0;
  std::array<double, N> slopes{};

  Dual(double number) : value(number) {}
  Dual(double number, std::size_t variable) : value(number) { slopes[variable] = 1.0; }
  /// f(a) or f(a, b) by its value and its partial derivatives.
  Dual(double number, double by_a, const Dual& a) : value(number) {
    for (std::size_t i = 0; i < N; ++i) slopes[i] = by_a * a.slopes[i];
  }
  Dual(double number, double by_a, const Dual& a, double by_b, const Dual& b) : value(number) {
    for (std::size_t i = 0; i < N; ++i) slopes[i] = by_a * a.slopes[i] + by_b * b.slopes[i];
  }
  /// Derivative along the direction `change` of the variables.
  double along(const std::array<double, N>& change) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < N; ++i) sum += slopes[i] * change[i];
    return sum;
  }

  friend Dual operator-(const Dual& a) { return {-a.value, -1.0, a}; }
  friend Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, 1.0, a, 1.0, b}; }
  friend Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, 1.0, a, -1.0, b}; }
  friend Dual operator*(const Dual& a, const Dual& b) { return {a.value * b.value, b.value, a, a.value, b}; }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double ratio = a.value / b.value, inverse = 1.0 / b.value;
    return {ratio, inverse, a, -ratio * inverse, b};
  }
  friend auto operator<=>(const Dual& a, const Dual& b) { return a.value <=> b.value; }
  friend Dual sqrt(const Dual& a) {
    const double root = std::sqrt(a.value);
    return {root, 0.5 / root, a};
  }
  friend Dual exp(const Dual& a) {
    const double power = elementary::exp(a.value);
    return {power, power, a};
  }
  friend Dual expm1(const Dual& a) {
    const double growth = elementary::expm1(a.value);
    return {growth, 1.0 + growth, a};
  }
  friend Dual log1p(const Dual& a) { return {elementary::log1p(a.value), 1.0 / (1.0 + a.value), a}; }
};

using elementary::exp, elementary::expm1, elementary::log1p, std::sqrt;

}  // namespace gas
