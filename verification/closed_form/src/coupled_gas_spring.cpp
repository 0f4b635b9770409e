// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "check.hpp"
#include "closed_form/coupled.hpp"

namespace closed_form {
namespace {

// Work on the gas over p_a V less that of the ambient air, over x = S s/V: ((1-x)^(1-gamma) - 1)/((gamma-1)
// x) - 1, for small x by its series. It grows with rise = -log(1-x) from 0.
double mean_overpressure(double gamma, double rise) {
  const double x = -std::expm1(-rise);
  if (x > 0.5) return std::expm1((gamma - 1.0) * rise) / ((gamma - 1.0) * x) - 1.0;
  double sum = 0.0, term = 0.5 * gamma * x;
  for (int k = 1; k < 100 && sum + term > sum; ++k) {
    sum += term;
    term *= (gamma + k) / (k + 2) * x;
  }
  return sum;
}

// The rise at which it is `load`, by bisection to the last bit.
double turning_point(double gamma, double load) {
  double low = 0.0, high = 1.0;
  while (mean_overpressure(gamma, high) < load) high *= 2.0;
  for (double mid = 0.5 * high; mid > low && mid < high; mid = 0.5 * (low + high))
    (mean_overpressure(gamma, mid) < load ? low : high) = mid;
  return high;
}

}  // namespace

// (K.59)
GasSpringSwing gas_spring(const GasSpring& spring, double force) {
  const double gamma = check::gas(spring.gas).heat_capacity_ratio;
  check::positive("mass", spring.mass, "area", spring.area, "volume", spring.volume, "ambient_pressure",
                  spring.ambient_pressure, "force", force);
  const double load = force / (spring.ambient_pressure * spring.area);
  const double rise = turning_point(gamma, load);
  // -log(1-x) = rise (1 - cos a)/2 takes both roots out of dt = ds/v, and the wall at x = 1; the midpoint
  // rule then converges exponentially.
  constexpr int kPoints = 256;
  double sum = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = std::numbers::pi * (i + 0.5) / kPoints,
                 to = rise * std::pow(std::sin(0.5 * angle), 2), x = -std::expm1(-to);
    sum +=
        0.5 * rise * std::sin(angle) * std::exp(-to) / std::sqrt(x * (load - mean_overpressure(gamma, to)));
  }
  const double height = spring.volume / spring.area;
  const double speed = std::sqrt(2.0 * spring.ambient_pressure * spring.volume / spring.mass);
  return {-std::expm1(-rise) * height, 2.0 * std::numbers::pi / kPoints * sum * height / speed,
          spring.ambient_pressure * std::exp(gamma * rise)};
}

}  // namespace closed_form
