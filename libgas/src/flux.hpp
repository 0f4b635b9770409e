// SPDX-License-Identifier: Apache-2.0
// The laws of flow, as templates for numbers and for numbers with derivatives.
#pragma once
#include "dual.hpp"

namespace gas {

/// The gas upstream of an opening.
template <class S>
struct Upstream {
  S pressure;      // [Pa] > 0
  S overpressure;  // [Pa] over the pressure downstream
  S temperature;   // [K]
  S gas_constant;  // [J/(kg K)]
  S gamma;         // [-]
  S density() const { return pressure / (gas_constant * temperature); }
};

/// log(2/(gamma + 1)): throat over stagnation temperature. log1p, because large exponents multiply its error.
template <class S>
S log_sonic_temperature(const S& gamma) {
  return log1p(S(-(gamma - 1.0) / (gamma + 1.0)));
}

/// Mass flux [kg/(s m2)] through a hole, (G.6); 0 if the overpressure is not positive.
template <class S>
S inviscid_hole_flux(const Upstream<S>& gas, const S& cp) {
  // No gas chokes at a pressure ratio above this: (G.5) tends to 0.6065 as gamma tends to 1.
  constexpr double kNeverChoked = 0.62;
  if (!(gas.overpressure > 0.0)) return S(0.0);
  const S &p = gas.pressure, &gamma = gas.gamma;
  const S rt = gas.gas_constant * gas.temperature, outside = p - gas.overpressure;
  if (outside < kNeverChoked * p) {
    // (2/(gamma + 1))^((gamma + 1)/(2 (gamma - 1))); the exponent of (G.5) is 1/2 more.
    const S throat = exp(S(0.5 * (gamma + 1.0) / (gamma - 1.0) * log_sonic_temperature(gamma)));
    if (outside <= throat * sqrt(2.0 / (gamma + 1.0)) * p) return p * sqrt(gamma / rt) * throat;
  }
  const S log_ratio = log1p(S(-gas.overpressure / p));            // of p_a/p
  const S cooling = expm1(S((gamma - 1.0) / gamma * log_ratio));  // T/T0 - 1
  const S density_ratio = outside / p / (1.0 + cooling);          // r^(1/gamma)
  return p / rt * density_ratio * sqrt(-2.0 * cp * gas.temperature * cooling);
}

/// Mass flux [kg/(s m2)] through porous fabric, (G.7).
template <class S>
S inviscid_fabric_flux(const S& density, const S& overpressure) {
  return overpressure > 0.0 ? S(sqrt(2.0 * density * overpressure)) : S(0.0);
}

/// Share of the inviscid flow that an opening passes at `overpressure` [Pa],                          (G.22)
///   (1 + (d/dp)^2)^(-3/4), d = `laminar_overpressure` [Pa].
/// Below d the flow falls as dp^2 in place of sqrt(dp). 0 for an overpressure that is not positive; 1 for
/// d = 0.
template <class S>
S laminar_factor(const S& overpressure, double laminar_overpressure) {
  // For q^2 below this, (1 + q^2)^(-3/4) equals 1 - 3/4 q^2 to one rounding.
  constexpr double kSmallSquare = 1e-8;
  if (!(overpressure > 0.0)) return S(0.0);
  const S q = laminar_overpressure / overpressure;
  if (q * q < kSmallSquare) return S(1.0 - 0.75 * q * q);
  const S root = sqrt(1.0 + q * q);
  return S(1.0 / (root * sqrt(root)));
}

/// Mass flux [kg/(s m2)] through a hole, (G.6) times (G.22).
template <class S>
S hole_flux(const Upstream<S>& gas, double laminar_overpressure) {
  const S cp = gas.gas_constant * gas.gamma / (gas.gamma - 1.0);
  return inviscid_hole_flux(gas, cp) * laminar_factor(gas.overpressure, laminar_overpressure);
}

/// The same through porous fabric, (G.7).
template <class S>
S fabric_flux(const Upstream<S>& gas, double laminar_overpressure) {
  return inviscid_fabric_flux(gas.density(), gas.overpressure) *
         laminar_factor(gas.overpressure, laminar_overpressure);
}

}  // namespace gas
