// SPDX-License-Identifier: Apache-2.0
#include "pressure_volume.hpp"

#include <algorithm>
#include <cmath>

#include "require.hpp"

namespace gas {
namespace {

// Newton's steps below this share of T are followed by two more: one may end across a knot, the next is
// quadratic.
constexpr double kSmallStep = 1e-8;
constexpr int kSmallSteps = 3;
constexpr int kMostNewtonSteps = 100;

}  // namespace

PressurePlace pressure_place(const Curve& curve, double ambient_pressure, double product) {
  const auto knots = curve.knots();
  const auto pressure = [&](const Curve::Knot& knot) { return ambient_pressure + knot.time; };
  if (const double v = knots.front().value; product <= pressure(knots.front()) * v)
    return {product / v, v, 0.0, 0.0, false};
  double work = 0.0;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double p = pressure(knots[i]), v = knots[i].value, grown = knots[i + 1].value - v;
    if (product <= pressure(knots[i + 1]) * knots[i + 1].value) {
      const double slope = grown / (knots[i + 1].time - knots[i].time);
      // (p + d)(v + slope d) = product, the root that does not cancel.
      const double b = v + slope * p, c = product - p * v;
      const double d = 2.0 * c / (b + std::sqrt(b * b + 4.0 * slope * c));
      return {p + d, v + slope * d, slope, work + slope * d * (p + 0.5 * d), false};
    }
    work += 0.5 * grown * (p + pressure(knots[i + 1]));
  }
  return {product / knots.back().value, knots.back().value, 0.0, work, true};
}

double heat_capacity(const PressurePlace& place, double cv, double gas_constant_sum) {
  const double taken = place.pressure * place.slope;
  return cv + gas_constant_sum * taken / (place.volume + taken);
}

std::optional<double> find_temperature(const Mixture& gas, const Curve& curve, double ambient_pressure,
                                       double energy, double guess) noexcept {
  double t = guess;
  int small = 0, outside = 0;
  for (int i = 0; i < kMostNewtonSteps && outside < 2; ++i) {
    const PressurePlace place = pressure_place(curve, ambient_pressure, gas.gas_constant_sum * t);
    const double excess = gas.internal_energy(t) + place.work - energy;
    const double next = t - excess / heat_capacity(place, gas.cv(t), gas.gas_constant_sum);
    if (!std::isfinite(next)) return {};
    const double kept = std::clamp(next, std::max(gas.minimum_temperature, 0.5 * t), gas.maximum_temperature);
    outside = kept == next || kept == 0.5 * t ? 0 : outside + 1;
    if (std::abs(kept - t) > kSmallStep * t)
      small = 0;
    else if (++small == kSmallSteps && outside == 0)
      return kept;
    t = kept;
  }
  return {};
}

std::string beyond_text(const Curve& curve) {
  return "the overpressure passes " + to_text(curve.knots().back().time) +
         " Pa, where the curve of the volume ends";
}

}  // namespace gas
