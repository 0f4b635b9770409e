// SPDX-License-Identifier: Apache-2.0
#include "flux.hpp"

#include <cmath>

#include "gas/orifice.hpp"

namespace gas {
namespace {

// (1 + q^2)^(-3/4) is 1 - 3/4 q^2 to a rounding for q^2 below this.
constexpr double kSmallSquare = 1e-8;

/// d ln(G.22) / d overpressure [1/Pa].
double laminar_log_slope(double overpressure, double d) {
  return 1.5 * d * d / (overpressure * (overpressure * overpressure + d * d));
}

/// Slopes of a flux ~ p^n T^(-1/2) R^(-1/2) that depends on both pressures by their ratio; the laminar factor
/// acts on their difference.
FluxSlopes slopes_of(double flux, const Upstream& gas, double d, double exponent, double by_gamma) {
  const double laminar = laminar_log_slope(gas.overpressure, d), downstream = gas.pressure - gas.overpressure;
  return {flux * (exponent / gas.pressure + laminar),
          flux * ((exponent == 1.0 ? 0.0 : (1.0 - exponent) / downstream) - laminar),
          -0.5 * flux / gas.temperature, -0.5 * flux / gas.gas_constant, flux * by_gamma};
}

/// d ln(G.6) / d gamma at the same p, T and R; `exponent` is (G.13), 1 of a choked hole.
double hole_by_gamma(const Upstream& gas, double exponent) {
  const double g = gas.gamma;
  if (exponent == 1.0) return 0.5 / g - 0.5 / (g - 1.0) - std::log(2.0 / (g + 1.0)) / ((g - 1.0) * (g - 1.0));
  const double l = std::log1p(-gas.overpressure / gas.pressure), first = std::exp(2.0 / g * l);
  const double difference = -first * std::expm1((g - 1.0) / g * l), second = first - difference;
  return 0.5 * (l * (second - 2.0 * first) / (g * g * difference) - 1.0 / (g * (g - 1.0)));
}

}  // namespace

double laminar_factor(double overpressure, double laminar_overpressure) {
  if (!(overpressure > 0.0)) return 0.0;
  const double q = laminar_overpressure / overpressure;
  if (q * q < kSmallSquare) return 1.0 - 0.75 * q * q;
  const double root = std::sqrt(1.0 + q * q);
  return 1.0 / (root * std::sqrt(root));
}

double hole_flux(const Upstream& gas, double laminar_overpressure) {
  if (!(gas.overpressure > 0.0)) return 0.0;
  const double cp = gas.gas_constant * gas.gamma / (gas.gamma - 1.0);
  return hole_mass_flow(1.0, gas.pressure, gas.temperature, gas.gas_constant, cp, gas.gamma,
                        gas.overpressure) *
         laminar_factor(gas.overpressure, laminar_overpressure);
}

FluxSlopes hole_flux_slopes(const Upstream& gas, double laminar_overpressure) {
  const double flux = hole_flux(gas, laminar_overpressure);
  if (flux == 0.0) return {};
  const double exponent = orifice_pressure_exponent(gas.gamma, gas.overpressure / gas.pressure);
  return slopes_of(flux, gas, laminar_overpressure, exponent, hole_by_gamma(gas, exponent));
}

double fabric_flux(const Upstream& gas, double laminar_overpressure) {
  return fabric_mass_flow(1.0, gas.pressure / (gas.gas_constant * gas.temperature), gas.overpressure) *
         laminar_factor(gas.overpressure, laminar_overpressure);
}

FluxSlopes fabric_flux_slopes(const Upstream& gas, double laminar_overpressure) {
  const double flux = fabric_flux(gas, laminar_overpressure);
  if (flux == 0.0) return {};
  return slopes_of(flux, gas, laminar_overpressure, fabric_pressure_exponent(gas.overpressure / gas.pressure),
                   0.0);
}

}  // namespace gas
