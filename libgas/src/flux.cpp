// SPDX-License-Identifier: Apache-2.0
#include "flux.hpp"

#include <cmath>

#include "gas/orifice.hpp"

namespace gas {
namespace {

// (1 + q^2)^(-3/4) is 1 - 3/4 q^2 to a rounding for q^2 below this.
constexpr double kSmallSquare = 1e-8;

double downstream(const Upstream& gas) {
  return gas.pressure - gas.overpressure;
}

bool is_choked(const Upstream& gas) {
  return downstream(gas) <= critical_pressure_ratio(gas.gamma) * gas.pressure;
}

/// d ln(G.22) / d overpressure [1/Pa].
double laminar_log_slope(double overpressure, double d) {
  return 1.5 * d * d / (overpressure * (overpressure * overpressure + d * d));
}

/// A flux and its logarithmic derivatives as slopes; the laminar factor acts on the overpressure.
FluxSlopes slopes_of(double flux, const Upstream& gas, double d, const FluxSlopes& logarithmic) {
  const double laminar = laminar_log_slope(gas.overpressure, d);
  return {flux * (logarithmic.upstream + laminar), flux * (logarithmic.downstream - laminar),
          flux * logarithmic.temperature, flux * logarithmic.gas_constant, flux * logarithmic.gamma};
}

/// d ln(flux) of a sonic hole.
FluxSlopes choked_log_slopes(const Upstream& gas) {
  const double g = gas.gamma, throat = std::log(2.0 / (g + 1.0));
  return {1.0 / gas.pressure, 0.0, -0.5 / gas.temperature, -0.5 / gas.gas_constant,
          0.5 / g - 0.5 / (g - 1.0) - throat / ((g - 1.0) * (g - 1.0))};
}

/// d ln(flux) of a subsonic hole, flux ~ p/sqrt(R T) sqrt(2 gamma/(gamma - 1) D), D = r^(2/gamma) - r^((gamma + 1)/gamma).
FluxSlopes subsonic_log_slopes(const Upstream& gas) {
  const double g = gas.gamma, l = std::log1p(-gas.overpressure / gas.pressure);
  const double first = std::exp(2.0 / g * l), second = first * std::exp((g - 1.0) / g * l);
  const double difference = -first * std::expm1((g - 1.0) / g * l);
  const double by_ratio = 0.5 * (2.0 * first - (g + 1.0) * second) / (g * difference);  // d ln(flux)/d l
  const double by_gamma = 0.5 * (l * (second - 2.0 * first) / (g * g * difference) - 1.0 / (g * (g - 1.0)));
  return {(1.0 - by_ratio) / gas.pressure, by_ratio / downstream(gas), -0.5 / gas.temperature,
          -0.5 / gas.gas_constant, by_gamma};
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
  return slopes_of(flux, gas, laminar_overpressure,
                   is_choked(gas) ? choked_log_slopes(gas) : subsonic_log_slopes(gas));
}

double fabric_flux(const Upstream& gas, double laminar_overpressure) {
  return fabric_mass_flow(1.0, gas.pressure / (gas.gas_constant * gas.temperature), gas.overpressure) *
         laminar_factor(gas.overpressure, laminar_overpressure);
}

FluxSlopes fabric_flux_slopes(const Upstream& gas, double laminar_overpressure) {
  const double flux = fabric_flux(gas, laminar_overpressure);
  if (flux == 0.0) return {};
  return slopes_of(flux, gas, laminar_overpressure,
                   {0.5 / gas.pressure + 0.5 / gas.overpressure, -0.5 / gas.overpressure,
                    -0.5 / gas.temperature, -0.5 / gas.gas_constant, 0.0});
}

}  // namespace gas
