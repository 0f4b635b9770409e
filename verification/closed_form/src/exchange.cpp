// SPDX-License-Identifier: Apache-2.0
#include "closed_form/exchange.hpp"

#include <algorithm>
#include <cmath>

#include "cancellation.hpp"
#include "check.hpp"
#include "closed_form/gas.hpp"
#include "closed_form/orifice.hpp"

namespace closed_form {
namespace {

struct Inrush {
  double sonic_rate;  // [Pa/s]
  double sonic_end;   // [s] 0 if the hole is subsonic from the start
  double root_begin;  // sqrt(1 - s) at sonic_end
  double root_rate;   // [1/s] at which it falls
};

Inrush inrush(const AmbientInrush& tank) {
  const double g = tank.gas.heat_capacity_ratio, rt = tank.gas.gas_constant * tank.ambient_temperature;
  const double p_a = tank.ambient_pressure, scale = g * tank.area * std::sqrt(rt) * p_a / tank.volume;
  const double critical = critical_pressure_ratio(g) * p_a;
  const double sonic_rate = scale * choked_flux_coefficient(g);
  const double first = std::max(tank.initial_pressure, critical);
  const double rise = -std::expm1((g - 1.0) / g * log_ratio(first, p_a));  // 1 - s
  // dt = V/(g sqrt(R T_a) A) dr/sqrt(2 g/(g-1) (r^(2/g) - r^((g+1)/g))), r = s^(g/(g-1)): 2 g/(g-1) d
  // sqrt(1-s).
  const double root_rate = scale / p_a * std::sqrt(2.0 * g / (g - 1.0)) * (g - 1.0) / (2.0 * g);
  return {sonic_rate, std::max(0.0, critical - tank.initial_pressure) / sonic_rate, std::sqrt(rise),
          root_rate};
}

void check_inrush(const AmbientInrush& tank) {
  check::gas(tank.gas);
  check::positive("volume", tank.volume, "area", tank.area, "initial_temperature", tank.initial_temperature,
                  "ambient_pressure", tank.ambient_pressure, "ambient_temperature", tank.ambient_temperature);
  check::from_below("initial_pressure", tank.initial_pressure, 0.0, tank.ambient_pressure);
}

double inrush_end(const Inrush& parts) {
  return parts.sonic_end + parts.root_begin / parts.root_rate;
}

double inrush_pressure(const AmbientInrush& tank, double time) {
  const Inrush parts = inrush(tank);
  if (time <= parts.sonic_end) return tank.initial_pressure + parts.sonic_rate * time;
  const double root = std::max(0.0, parts.root_begin - parts.root_rate * (time - parts.sonic_end));
  const double g = tank.gas.heat_capacity_ratio;
  return tank.ambient_pressure * std::exp(g / (g - 1.0) * std::log1p(-root * root));
}

}  // namespace

GasState ambient_inrush(const AmbientInrush& tank, double time) {
  check_inrush(tank);
  check::non_negative("time", time);
  const auto [R, gamma] = tank.gas;
  const double pressure = inrush_pressure(tank, time);
  const double mass =
      tank.initial_pressure * tank.volume / (R * tank.initial_temperature) +
      (pressure - tank.initial_pressure) * tank.volume / (gamma * R * tank.ambient_temperature);
  // An empty tank has no temperature; the limit t -> 0 is returned.
  const double temperature =
      mass > 0.0 ? pressure * tank.volume / (mass * R) : gamma * tank.ambient_temperature;
  return {mass, temperature, pressure, tank.volume};
}

double ambient_inrush_end(const AmbientInrush& tank) {
  check_inrush(tank);
  return inrush_end(inrush(tank));
}

GasState heat_loss_fill(const HeatLossFill& tank, double time) {
  check::gas(tank.gas);
  check::positive("volume", tank.volume, "initial_pressure", tank.initial_pressure, "initial_temperature",
                  tank.initial_temperature);
  check::non_negative("mass_flow", tank.mass_flow);
  check::positive("inflow_temperature", tank.inflow_temperature);
  check::non_negative("conductance", tank.conductance);
  check::positive("outside_temperature", tank.outside_temperature);
  check::non_negative("time", time);
  const double R = tank.gas.gas_constant, cv = specific_heat_cv(tank.gas), cp = specific_heat_cp(tank.gas);
  const double mass0 = tank.initial_pressure * tank.volume / (R * tank.initial_temperature);
  const double mass = mass0 + tank.mass_flow * time;
  const double capacity_flow = tank.mass_flow * cv;                                         // [W/K]
  double limit = tank.outside_temperature, decay = tank.conductance * time / (mass0 * cv);  // exponent
  if (capacity_flow > 0.0) {
    limit = (tank.mass_flow * cp * tank.inflow_temperature + tank.conductance * tank.outside_temperature) /
            (capacity_flow + tank.conductance);
    decay = (1.0 + tank.conductance / capacity_flow) * std::log1p(tank.mass_flow * time / mass0);
  }
  const double temperature = tank.initial_temperature * std::exp(-decay) - limit * std::expm1(-decay);
  return {mass, temperature, mass * R * temperature / tank.volume, tank.volume};
}

GasState linear_fabric_tank(const LinearFabricTank& tank, double time) {
  check::gas(tank.gas);
  check::positive("volume", tank.volume, "area", tank.area, "permeability", tank.permeability,
                  "initial_temperature", tank.initial_temperature, "ambient_pressure", tank.ambient_pressure);
  check::above_upto("initial_pressure", tank.initial_pressure, tank.ambient_pressure, 1e12);
  check::non_negative("time", time);
  const auto [R, gamma] = tank.gas;
  const double rate = gamma * tank.permeability * tank.area * tank.ambient_pressure / tank.volume;
  const double p0 = tank.initial_pressure, p_a = tank.ambient_pressure;
  const double pressure = p_a * p0 / (p_a - (p0 - p_a) * std::expm1(-rate * time));
  const double temperature = tank.initial_temperature * std::pow(pressure / p0, (gamma - 1.0) / gamma);
  return {pressure * tank.volume / (R * temperature), temperature, pressure, tank.volume};
}

}  // namespace closed_form
