// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "check.hpp"
#include "closed_form/orifice.hpp"
#include "quadrature.hpp"

namespace closed_form {
namespace {

void check_tank(const PorousTank& tank) {
  check::gas(tank.gas);
  check::positive("volume", tank.volume);
  check::above_upto("porosity", tank.porosity, 0.0, 1.0);
  check::positive("fabric_area", tank.fabric_area);
  check::positive("initial_pressure", tank.initial_pressure);
  check::positive("initial_temperature", tank.initial_temperature);
  check::positive("ambient_pressure", tank.ambient_pressure);
  if (tank.initial_pressure <= tank.ambient_pressure)
    check::refuse("initial_pressure", tank.initial_pressure, "must be > ambient_pressure");
}

// v0 = sqrt(p0/p_a - 1).
double start_variable(const PorousTank& tank) {
  return std::sqrt((tank.initial_pressure - tank.ambient_pressure) / tank.ambient_pressure);
}

double isothermal_rate(const PorousTank& tank) {  // k [1/s]
  const double area = leak_area(tank.porosity, tank.fabric_area, tank.law);
  return area * std::sqrt(0.5 * tank.gas.gas_constant * tank.initial_temperature) / tank.volume;
}

// Time scale 2 V sqrt(rho_f)/(gamma C sqrt(2 p_a)) of the adiabatic solution, rho_f at p_a on the isentrope.
double adiabatic_scale(const PorousTank& tank) {
  const auto [R, gamma] = tank.gas;
  const double area = leak_area(tank.porosity, tank.fabric_area, tank.law);
  const double density = tank.initial_pressure / (R * tank.initial_temperature) *
                         std::pow(tank.ambient_pressure / tank.initial_pressure, 1.0 / gamma);
  return 2.0 * tank.volume * std::sqrt(density) / (gamma * area * std::sqrt(2.0 * tank.ambient_pressure));
}

double adiabatic_exponent(const PorousTank& tank) {
  return 0.5 / tank.gas.heat_capacity_ratio - 1.0;
}

GasState state_at(const PorousTank& tank, double pressure, double temperature) {
  return {pressure * tank.volume / (tank.gas.gas_constant * temperature), temperature, pressure, tank.volume};
}

}  // namespace

double porous_tank_isothermal_end(const PorousTank& tank) {
  check_tank(tank);
  return std::asinh(start_variable(tank)) / isothermal_rate(tank);  // arcosh sqrt(p0/p_a), no cancellation
}

GasState porous_tank_isothermal(const PorousTank& tank, double time) {
  check_tank(tank);
  check::non_negative("time", time);
  const double u = std::fmax(std::asinh(start_variable(tank)) - isothermal_rate(tank) * time, 0.0);
  const double root = std::cosh(u);
  return state_at(tank, tank.ambient_pressure * root * root, tank.initial_temperature);
}

double porous_tank_adiabatic_end(const PorousTank& tank) {
  check_tank(tank);
  return adiabatic_scale(tank) * quadrature::power_integral(adiabatic_exponent(tank), start_variable(tank));
}

GasState porous_tank_adiabatic(const PorousTank& tank, double time) {
  check_tank(tank);
  check::non_negative("time", time);
  const double gamma = tank.gas.heat_capacity_ratio;
  const double left = (porous_tank_adiabatic_end(tank) - time) / adiabatic_scale(tank);
  const double v = quadrature::power_integral_inverse(adiabatic_exponent(tank), left, start_variable(tank));
  const double pressure = tank.ambient_pressure * (1.0 + v * v);
  return state_at(
      tank, pressure,
      tank.initial_temperature * std::pow(pressure / tank.initial_pressure, (gamma - 1.0) / gamma));
}

double porous_tank_parabola_end(const PorousTank& tank) {
  check_tank(tank);
  return adiabatic_scale(tank) * start_variable(tank);
}

}  // namespace closed_form
