// SPDX-License-Identifier: Apache-2.0
#include "gas/orifice.hpp"

#include "flux.hpp"

namespace gas {

double critical_pressure_ratio(double gamma) {
  return elementary::exp(gamma / (gamma - 1.0) * log_sonic_temperature(gamma));
}

double orifice_mass_flow(double effective_area, double pressure, double temperature, double gas_constant,
                         double cp, double gamma, double ambient_pressure) {
  // The difference is exact where the pressures are within a factor of 2.
  const double overpressure = pressure - ambient_pressure;
  return effective_area *
         inviscid_hole_flux<double>({pressure, overpressure, temperature, gas_constant, gamma}, cp);
}

double fabric_mass_flow(double leak_area, double density, double overpressure) {
  return leak_area * inviscid_fabric_flux(density, overpressure);
}

double orifice_pressure_exponent(double gamma, double overpressure_share) {
  using Number = Dual<1>;  // derivative by p, at p = 1
  const Number flux = hole_flux<Number>({{1.0, 0}, {overpressure_share, 0}, 1.0, 1.0, gamma}, 0.0);
  return flux.slopes[0] / flux.value;
}

double fabric_pressure_exponent(double overpressure_share) {
  return 0.5 + 0.5 / overpressure_share;
}

double outflow_relaxation_rate(double gamma, double flow_per_mass, double pressure_exponent,
                               double compliance) {
  const double b = 1.0 + (gamma * (pressure_exponent + 0.5) - 0.5) / compliance;
  return 0.5 * flow_per_mass * (b + std::sqrt(b * b - 4.0 * gamma * pressure_exponent / compliance));
}

}  // namespace gas
