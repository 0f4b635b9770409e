// SPDX-License-Identifier: Apache-2.0
#include "closed_form/orifice.hpp"

#include <cmath>

#include "check.hpp"

namespace closed_form {
namespace {

// sqrt(2 gamma/(gamma-1) (r^(2/gamma) - r^((gamma+1)/gamma))) with r = 1 - epsilon, free of cancellation.
double isentropic_flux(double gamma, double epsilon) {
  const double log_r = std::log1p(-epsilon);
  const double bracket = -std::exp(2.0 / gamma * log_r) * std::expm1((gamma - 1.0) / gamma * log_r);
  return std::sqrt(2.0 * gamma / (gamma - 1.0) * bracket);
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
  check::gas(orifice.gas);
  check::positive("area", orifice.area);
  check::above_upto("discharge_coefficient", orifice.discharge_coefficient, 0.0, 1.0);
  check::positive("pressure", orifice.pressure);
  check::positive("temperature", orifice.temperature);
  check::non_negative("ambient_pressure", orifice.ambient_pressure);
  if (orifice.ambient_pressure >= orifice.pressure) return 0.0;
  const auto [R, gamma] = orifice.gas;
  const bool choked = orifice.ambient_pressure <= critical_pressure_ratio(gamma) * orifice.pressure;
  const double epsilon = (orifice.pressure - orifice.ambient_pressure) / orifice.pressure;
  const double flux = choked ? choked_flux_coefficient(gamma) : isentropic_flux(gamma, epsilon);
  return orifice.discharge_coefficient * orifice.area * orifice.pressure /
         std::sqrt(R * orifice.temperature) * flux;
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
  check::gas(fabric.gas);
  check::positive("pressure", fabric.pressure);
  check::positive("temperature", fabric.temperature);
  check::non_negative("ambient_pressure", fabric.ambient_pressure);
  const double area = leak_area(fabric.porosity, fabric.fabric_area, fabric.law);
  if (fabric.ambient_pressure >= fabric.pressure) return 0.0;
  const double density = fabric.pressure / (fabric.gas.gas_constant * fabric.temperature);
  return area * std::sqrt(2.0 * density * (fabric.pressure - fabric.ambient_pressure));
}

}  // namespace closed_form
