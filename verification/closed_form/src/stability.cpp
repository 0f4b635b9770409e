// SPDX-License-Identifier: Apache-2.0
#include "closed_form/stability.hpp"

#include <cmath>
#include <numbers>

#include "check.hpp"

namespace closed_form {

CentralDifference central_difference(double omega_dt) {
  check::positive("omega_dt", omega_dt);
  CentralDifference result;
  result.energy_amplitude = 0.25 * omega_dt * omega_dt;
  if (omega_dt <= 2.0) {
    result.frequency_ratio = 2.0 * std::asin(0.5 * omega_dt) / omega_dt;
    return result;
  }
  result.frequency_ratio = std::numbers::pi / omega_dt;
  const double excess = 0.5 * (omega_dt - 2.0) * (omega_dt + 2.0);  // W^2/2 - 2
  result.growth_per_step = 1.0 + excess + std::sqrt(excess * (excess + 2.0));
  return result;
}

double critical_time_step(double angular_frequency) {
  return 2.0 / check::positive("angular_frequency", angular_frequency);
}

double gas_breathing_frequency(const EnclosedGas& bag) {
  check::gas(bag.gas);
  check::positive("pressure", bag.pressure);
  check::positive("volume", bag.volume);
  check::positive("area", bag.area);
  check::positive("area_density", bag.area_density);
  return std::sqrt(bag.gas.heat_capacity_ratio * bag.pressure * bag.area / (bag.volume * bag.area_density));
}

double lagged_pressure_growth(double omega_structure_dt, double omega_gas_dt) {
  check::non_negative("omega_structure_dt", omega_structure_dt);
  check::non_negative("omega_gas_dt", omega_gas_dt);
  const double half = 1.0 - 0.5 * omega_structure_dt * omega_structure_dt;
  const double product = 1.0 + omega_gas_dt * omega_gas_dt;
  const double discriminant = half * half - product;
  if (discriminant <= 0.0) return std::sqrt(product);
  return std::abs(half) + std::sqrt(discriminant);
}

double euler_volume_work_drift(double heat_capacity_ratio, double delta) {
  const double gamma = check::heat_capacity_ratio(heat_capacity_ratio);
  if (!(delta > -1.0 && (gamma - 1.0) * delta < 1.0))
    check::refuse("delta", delta, "must be > -1 and < 1/(gamma - 1)");
  return std::log1p(-(gamma - 1.0) * delta) + (gamma - 1.0) * std::log1p(delta);
}

double trapezoid_volume_work_drift(double heat_capacity_ratio, double delta) {
  const double gamma = check::heat_capacity_ratio(heat_capacity_ratio);
  if (!(delta > -1.0 && 0.5 * (gamma - 1.0) * delta < 1.0 && 0.5 * (gamma + 1.0) * delta > -1.0))
    check::refuse("delta", delta, "must be > -2/(gamma + 1) and < 2/(gamma - 1)");
  // The three logarithms cancel to third order: extended precision keeps eight digits at delta = 1e-4.
  const long double g = gamma;
  const long double d = delta;
  return static_cast<double>(std::log1p(-0.5L * (g - 1.0L) * d) - std::log1p(0.5L * (g + 1.0L) * d) +
                             g * std::log1p(d));
}

double vent_equalisation_rate(const VentEqualisation& vent) {
  check::gas(vent.gas);
  check::positive("volume", vent.volume);
  check::positive("area", vent.area);
  check::positive("ambient_pressure", vent.ambient_pressure);
  check::positive("temperature", vent.temperature);
  const double density = vent.ambient_pressure / (vent.gas.gas_constant * vent.temperature);
  return vent.gas.heat_capacity_ratio * vent.ambient_pressure * vent.area /
         (vent.volume * std::sqrt(2.0 * density));
}

double vent_eigenvalue(const VentEqualisation& vent, double overpressure) {
  return -vent_equalisation_rate(vent) / std::sqrt(check::positive("overpressure", overpressure));
}

double vent_chatter_amplitude(const VentEqualisation& vent, double time_step) {
  const double root = vent_equalisation_rate(vent) * check::positive("time_step", time_step);
  return root * root;
}

double node_contact_time_step(const Sheet& sheet, double tributary_area, double stiffness) {
  check::sheet(sheet, true);
  check::positive("tributary_area", tributary_area);
  check::positive("stiffness", stiffness);
  return 2.0 * std::sqrt(sheet.density * sheet.thickness * tributary_area / stiffness);
}

}  // namespace closed_form
