// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace gas {

/// The gas upstream of an opening.
struct Upstream {
  double pressure;      // [Pa] > 0
  double overpressure;  // [Pa] over the pressure downstream
  double temperature;   // [K]
  double gas_constant;  // [J/(kg K)]
  double gamma;         // [-]
};

/// Derivatives of a flux. `upstream` and `downstream` are those by the two pressures.
struct FluxSlopes {
  double upstream, downstream;  // [kg/(s m2 Pa)]
  double temperature;           // [kg/(s m2 K)]
  double gas_constant;          // [kg/(s m2)] per [J/(kg K)]
  double gamma;                 // [kg/(s m2)]
};

/// Share of the inviscid flow that an opening passes at `overpressure` [Pa],                          (G.22)
///   (1 + (d/dp)^2)^(-3/4), d = `laminar_overpressure` [Pa].
/// Below d the flow falls as dp^2 in place of sqrt(dp). 0 for an overpressure that is not positive; 1 for
/// d = 0.
double laminar_factor(double overpressure, double laminar_overpressure);

/// Mass flux [kg/(s m2)] through a hole, (G.6) times (G.22); 0 if the overpressure is not positive.
double hole_flux(const Upstream& gas, double laminar_overpressure);
/// Its derivatives.
FluxSlopes hole_flux_slopes(const Upstream& gas, double laminar_overpressure);

/// The same through porous fabric, (G.7).
double fabric_flux(const Upstream& gas, double laminar_overpressure);
FluxSlopes fabric_flux_slopes(const Upstream& gas, double laminar_overpressure);

}  // namespace gas
