// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Outflow laws as pointwise functions. Preconditions: all arguments finite, pressures >= 0, temperature and
/// density > 0 where p > 0, areas >= 0, gamma = cp/(cp - R) > 1. Nothing flows where p <= ambient_pressure.
namespace gas {

/// Ratio of throat to upstream pressure at which a hole chokes, (2/(gamma+1))^(gamma/(gamma-1)).      (G.5)
/// Source: A. H. Shapiro, Compressible Fluid Flow, vol. 1, 1953, ch. 4.
double critical_pressure_ratio(double gamma);

/// Mass flow [kg/s] through a hole, isentropic, sonic or subsonic:                                    (G.6)
///   mdot = Cd A p/(R T) sqrt(2 cp T (r^(2/gamma) - r^((gamma+1)/gamma))), r = max(p_a/p, (G.5)).
/// The difference of powers is taken through expm1 and log1p: relative error below 1e-13 down to (p - p_a)/p
/// = 1e-14.
double orifice_mass_flow(double effective_area /* Cd A [m2] */, double pressure /* [Pa] */,
                         double temperature /* [K] */, double gas_constant /* [J/(kg K)] */,
                         double cp /* [J/(kg K)] */, double gamma, double ambient_pressure /* [Pa] */);

/// The two branches of (G.6), each continued smoothly past the switch; the subsonic one is zero for p <= p_a.
double choked_mass_flow(double effective_area, double pressure, double temperature, double gas_constant,
                        double gamma);
double subsonic_mass_flow(double effective_area, double pressure, double temperature, double gas_constant,
                          double cp, double gamma, double ambient_pressure);

/// Mass flow [kg/s] through porous fabric, leak_area sqrt(2 rho (p - p_a)), never choked.             (G.7)
/// leak_area [m2] is sum eta^2 A for the printed law, sum eta A for the screen law (eta: porosity, A: element
/// area).
double fabric_mass_flow(double leak_area /* [m2] */, double density /* [kg/m3] */, double pressure /* [Pa] */,
                        double ambient_pressure /* [Pa] */);

}  // namespace gas
