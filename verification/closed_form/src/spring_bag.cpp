// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "check.hpp"
#include "closed_form/gas.hpp"
#include "closed_form/orifice.hpp"

namespace closed_form {

GasState spring_bag_fill(const SpringBag& bag, double mass, double temperature) {
  check::gas(bag.gas);
  check::positive("initial_pressure", bag.initial_pressure);
  check::positive("initial_temperature", bag.initial_temperature);
  check::positive("initial_volume", bag.initial_volume);
  check::non_negative("compliance", bag.compliance);
  check::non_negative("inflow_mass", mass);
  check::positive("inflow_temperature", temperature);
  const auto [R, gamma] = bag.gas;
  const double p0 = bag.initial_pressure, v0 = bag.initial_volume, k = bag.compliance;
  const double supplied = mass * gamma * R / (gamma - 1.0) * temperature;
  // a d^2 + b d = supplied, with d = p - p0; the root that does not cancel.
  const double a = k * (1.0 / (gamma - 1.0) + 0.5), b = (v0 + k * p0) / (gamma - 1.0) + k * p0;
  const double d = 2.0 * supplied / (b + std::sqrt(b * b + 4.0 * a * supplied));
  const double p = p0 + d, v = v0 + k * d, m = p0 * v0 / (R * bag.initial_temperature) + mass;
  return {m, p * v / (m * R), p, v};
}

GasState proportional_blowdown(const Blowdown& bag, double time) {
  check::gas(bag.gas);
  check::positive("volume", bag.volume);
  check::positive("area", bag.area);
  check::above_upto("discharge_coefficient", bag.discharge_coefficient, 0.0, 1.0);
  check::positive("initial_pressure", bag.initial_pressure);
  check::positive("initial_temperature", bag.initial_temperature);
  check::non_negative("ambient_pressure", bag.ambient_pressure);
  check::non_negative("time", time);
  const auto [R, gamma] = bag.gas;
  const double rate = bag.discharge_coefficient * bag.area * choked_flux_coefficient(gamma) *
                      std::sqrt(R * bag.initial_temperature) / bag.volume;
  const double a = (gamma - 1.0) / gamma, left = 1.0 - 0.5 * rate * time;
  const double x = left > 0.0 ? std::pow(left, 2.0 / (2.0 - a)) : 0.0;
  if (!(critical_pressure_ratio(gamma) * x * bag.initial_pressure >= bag.ambient_pressure && x > 0.0))
    check::refuse("time", time, "the vent must be choked up to then");
  const double p = bag.initial_pressure * x, v = bag.volume * x,
               temperature = bag.initial_temperature * std::pow(x, a);
  return {p * v / (R * temperature), temperature, p, v};
}

}  // namespace closed_form
