// SPDX-License-Identifier: Apache-2.0
#include "closed_form/orifice.hpp"

#include <cmath>

#include "check.hpp"
#include "quadrature.hpp"

namespace closed_form {
namespace {

// sqrt(2 gamma/(gamma-1) (r^(2/gamma) - r^((gamma+1)/gamma))) with r = 1 - epsilon, free of cancellation.
double isentropic_flux(double gamma, double epsilon) {
  const double log_r = std::log1p(-epsilon);
  const double bracket = -std::exp(2.0 / gamma * log_r) * std::expm1((gamma - 1.0) / gamma * log_r);
  return std::sqrt(2.0 * gamma / (gamma - 1.0) * bracket);
}

// At an overpressure p - p_a that the difference of the pressures may be too coarse for.
double flow_at(const Orifice& orifice, double overpressure) {
  check::gas(orifice.gas);
  check::positive("area", orifice.area);
  check::above_upto("discharge_coefficient", orifice.discharge_coefficient, 0.0, 1.0);
  check::positive("pressure", orifice.pressure, "temperature", orifice.temperature);
  check::non_negative("ambient_pressure", orifice.ambient_pressure);
  if (!(overpressure > 0.0)) return 0.0;
  const auto [R, gamma] = orifice.gas;
  const bool choked = orifice.ambient_pressure <= critical_pressure_ratio(gamma) * orifice.pressure;
  const double flux =
      choked ? choked_flux_coefficient(gamma) : isentropic_flux(gamma, overpressure / orifice.pressure);
  return orifice.discharge_coefficient * orifice.area * orifice.pressure /
         std::sqrt(R * orifice.temperature) * flux;
}

double flow_at(const PorousFabric& fabric, double overpressure) {
  check::gas(fabric.gas);
  check::positive("pressure", fabric.pressure, "temperature", fabric.temperature);
  check::non_negative("ambient_pressure", fabric.ambient_pressure);
  const double area = leak_area(fabric.porosity, fabric.fabric_area, fabric.law);
  if (!(overpressure > 0.0)) return 0.0;
  const double density = fabric.pressure / (fabric.gas.gas_constant * fabric.temperature);
  return area * std::sqrt(2.0 * density * overpressure);
}

void check_tank(const PorousTank& tank) {
  check::gas(tank.gas);
  check::positive("volume", tank.volume);
  check::above_upto("porosity", tank.porosity, 0.0, 1.0);
  check::positive("fabric_area", tank.fabric_area, "initial_pressure", tank.initial_pressure,
                  "initial_temperature", tank.initial_temperature, "ambient_pressure", tank.ambient_pressure);
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

double critical_pressure_ratio(double heat_capacity_ratio) {
  const double gamma = check::heat_capacity_ratio(heat_capacity_ratio);
  return std::exp(-gamma / (gamma - 1.0) * std::log1p(0.5 * (gamma - 1.0)));
}

double choked_flux_coefficient(double heat_capacity_ratio) {
  const double gamma = check::heat_capacity_ratio(heat_capacity_ratio);
  return std::sqrt(gamma) * std::exp(-0.5 * (gamma + 1.0) / (gamma - 1.0) * std::log1p(0.5 * (gamma - 1.0)));
}

double orifice_mass_flow(const Orifice& orifice) {
  return flow_at(orifice, orifice.pressure - orifice.ambient_pressure);
}

double orifice_mass_flow(Orifice orifice, double overpressure) {
  orifice.pressure = orifice.ambient_pressure + overpressure;
  return flow_at(orifice, overpressure);
}

double choking_overpressure(double heat_capacity_ratio, double ambient_pressure) {
  check::positive("ambient_pressure", ambient_pressure);
  return ambient_pressure * (1.0 / critical_pressure_ratio(heat_capacity_ratio) - 1.0);
}

double bernoulli_ratio(double heat_capacity_ratio, double epsilon) {
  check::above_upto("epsilon", epsilon, 0.0, 1.0 - critical_pressure_ratio(heat_capacity_ratio));
  return isentropic_flux(heat_capacity_ratio, epsilon) / std::sqrt(2.0 * epsilon);
}

double bernoulli_ratio_series(double heat_capacity_ratio, double epsilon) {
  check::above_upto("epsilon", epsilon, 0.0, 1.0 - critical_pressure_ratio(heat_capacity_ratio));
  const double gamma = heat_capacity_ratio;
  return 1.0 - epsilon * (3.0 / (4.0 * gamma) + epsilon * (40.0 * gamma - 29.0) / (96.0 * gamma * gamma));
}

double leak_area(double porosity, double fabric_area, PorosityLaw law) {
  check::within("porosity", porosity, 0.0, 1.0);
  check::non_negative("fabric_area", fabric_area);
  return (law == PorosityLaw::printed ? porosity * porosity : porosity) * fabric_area;
}

double porous_mass_flow(const PorousFabric& fabric) {
  return flow_at(fabric, fabric.pressure - fabric.ambient_pressure);
}

double porous_mass_flow(PorousFabric fabric, double overpressure) {
  fabric.pressure = fabric.ambient_pressure + overpressure;
  return flow_at(fabric, overpressure);
}

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
