// SPDX-License-Identifier: Apache-2.0
#include "gas/orifice.hpp"

#include <cmath>

namespace gas {
namespace {

// log(2/(gamma + 1)), of the throat's temperature over that at rest; by log1p, as its exponents multiply the
// error.
double log_sonic_temperature(double gamma) {
  return std::log1p(-(gamma - 1.0) / (gamma + 1.0));
}

// No gas chokes at a pressure ratio above this: (G.5) tends to 0.6065 as gamma tends to 1.
constexpr double kNeverChoked = 0.62;

/// (2/(gamma + 1))^((gamma + 1)/(2 (gamma - 1))), of the sonic flux.
double throat_flux(double gamma) {
  return std::exp(0.5 * (gamma + 1.0) / (gamma - 1.0) * log_sonic_temperature(gamma));
}

double log_critical_ratio(double gamma) {
  return gamma / (gamma - 1.0) * log_sonic_temperature(gamma);
}

}  // namespace

double critical_pressure_ratio(double gamma) {
  return std::exp(log_critical_ratio(gamma));
}

double hole_mass_flow(double effective_area, double pressure, double temperature, double gas_constant,
                      double cp, double gamma, double overpressure) {
  if (!(overpressure > 0.0)) return 0.0;
  const double outside = pressure - overpressure;
  if (outside < kNeverChoked * pressure) {
    const double throat = throat_flux(gamma);  // also of (G.5): its exponent is half less
    if (outside <= throat * std::sqrt(2.0 / (gamma + 1.0)) * pressure)
      return effective_area * pressure * std::sqrt(gamma / (gas_constant * temperature)) * throat;
  }
  const double log_ratio = std::log1p(-overpressure / pressure);  // of p_a/p
  const double powers = std::exp(2.0 / gamma * log_ratio) * -std::expm1((gamma - 1.0) / gamma * log_ratio);
  return effective_area * pressure / (gas_constant * temperature) *
         std::sqrt(2.0 * cp * temperature * powers);
}

double orifice_mass_flow(double effective_area, double pressure, double temperature, double gas_constant,
                         double cp, double gamma, double ambient_pressure) {
  // The difference is exact where it matters, within a factor of 2.
  return hole_mass_flow(effective_area, pressure, temperature, gas_constant, cp, gamma,
                        pressure - ambient_pressure);
}

double fabric_mass_flow(double leak_area, double density, double overpressure) {
  return overpressure > 0.0 ? leak_area * std::sqrt(2.0 * density * overpressure) : 0.0;
}

double orifice_pressure_exponent(double gamma, double overpressure_share) {
  const double log_ratio = std::log1p(-overpressure_share);
  if (log_ratio <= log_critical_ratio(gamma)) return 1.0;
  const double first = std::exp(2.0 / gamma * log_ratio);
  const double second = std::exp((gamma + 1.0) / gamma * log_ratio);
  const double difference = -first * std::expm1((gamma - 1.0) / gamma * log_ratio);
  return 1.0 - (2.0 * first - (gamma + 1.0) * second) / (2.0 * gamma * difference);
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
