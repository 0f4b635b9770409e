// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Outflow laws as pointwise functions. Preconditions: all arguments finite, pressures >= 0, temperature and
/// density > 0 where p > 0, areas >= 0, gamma = cp/(cp - R) > 1. The flow is zero where p <=
/// ambient_pressure.
namespace gas {

/// Ratio of throat to upstream pressure at which a hole chokes, (2/(gamma+1))^(gamma/(gamma-1)).      (G.5)
/// Source: A. H. Shapiro, Compressible Fluid Flow, vol. 1, 1953, ch. 4.
double critical_pressure_ratio(double gamma);

/// Mass flow [kg/s] through a hole, isentropic, sonic or subsonic:                                    (G.6)
///   mdot = Cd A p/(R T) sqrt(2 cp T (r^(2/gamma) - r^((gamma+1)/gamma))), r = max(p_a/p, (G.5)).
/// The difference of powers is computed with expm1 and log1p. The relative error is below 1e-13 down to
/// (p - p_a)/p = 1e-14.
double orifice_mass_flow(double effective_area /* Cd A [m2] */, double pressure /* [Pa] */,
                         double temperature /* [K] */, double gas_constant /* [J/(kg K)] */,
                         double cp /* [J/(kg K)] */, double gamma, double ambient_pressure /* [Pa] */);

/// Mass flow [kg/s] through porous fabric, leak_area sqrt(2 rho (p - p_a)), never choked.             (G.7)
/// leak_area [m2] is sum eta^2 A for the printed law and sum eta A for the screen law (eta: porosity, A:
/// element area).
double fabric_mass_flow(double leak_area /* [m2] */, double density /* [kg/m3] */,
                        double overpressure /* p - p_a [Pa] */);

/// Exponent n = d ln mdot / d ln p [-] of (G.6) at constant T: 1 if sonic; if subsonic               (G.13)
///   n = 1 - (2 r^(2/gamma) - (gamma + 1) r^((gamma+1)/gamma))/(2 gamma (r^(2/gamma) - r^((gamma+1)/gamma))),
/// with r = p_a/p < 1. `overpressure_share` is (p - p_a)/p. As p -> p_a it grows as p/(2 (p - p_a)).
double orifice_pressure_exponent(double gamma, double overpressure_share);

/// Exponent of the fabric's flow (G.7) at constant T: 1/2 + p/(2 (p - p_a)) for p > p_a.
double fabric_pressure_exponent(double overpressure_share);

/// Faster of the two relaxation rates [1/s] of mass and energy in a volume that gas leaves:           (G.14)
///   mdot/m (b + sqrt(b^2 - 4 gamma n/c))/2, b = 1 + (gamma (n + 1/2) - 1/2)/c,
/// where mdot ~ p^n/sqrt(T), `flow_per_mass` = mdot/m [1/s], `pressure_exponent` = n, and `compliance` is
/// c = 1 + gamma (p/V) dV/dp, 1 for a rigid volume. Source: linearised (G.9), (G.10).
double outflow_relaxation_rate(double gamma, double flow_per_mass, double pressure_exponent,
                               double compliance = 1.0);

}  // namespace gas
