// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "check.hpp"
#include "closed_form/coupled.hpp"

namespace closed_form {
namespace {

// Work on the gas over p_a V less that of the ambient air, over x = S s/V: ((1-x)^(1-gamma) - 1)/((gamma-1)
// x)
// - 1. It grows with x from 0.
double mean_overpressure(double gamma, double x) {
  return std::expm1((1.0 - gamma) * std::log1p(-x)) / ((gamma - 1.0) * x) - 1.0;
}

// The x at which it is `load`, by bisection to the last bit.
double turning_point(double gamma, double load) {
  double low = 0.0, high = 1.0;
  for (double mid = 0.5; mid > low && mid < high; mid = 0.5 * (low + high))
    (mean_overpressure(gamma, mid) < load ? low : high) = mid;
  return low;
}

}  // namespace

// (K.59)
GasSpringSwing gas_spring(const GasSpring& spring, double force) {
  const double gamma = check::gas(spring.gas).heat_capacity_ratio;
  check::positive("mass", spring.mass, "area", spring.area, "volume", spring.volume, "ambient_pressure",
                  spring.ambient_pressure, "force", force);
  const double load = force / (spring.ambient_pressure * spring.area);
  const double turn = turning_point(gamma, load);
  // x = turn (1 - cos a)/2 takes both roots out of dt = ds/v; the midpoint rule then converges exponentially.
  constexpr int kPoints = 256;
  double sum = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = std::numbers::pi * (i + 0.5) / kPoints,
                 x = turn * std::pow(std::sin(0.5 * angle), 2);
    sum += 0.5 * turn * std::sin(angle) / std::sqrt(x * (load - mean_overpressure(gamma, x)));
  }
  const double height = spring.volume / spring.area;
  const double speed = std::sqrt(2.0 * spring.ambient_pressure * spring.volume / spring.mass);
  return {turn * height, 2.0 * std::numbers::pi / kPoints * sum * height / speed,
          spring.ambient_pressure * std::pow(1.0 - turn, -gamma)};
}

}  // namespace closed_form
