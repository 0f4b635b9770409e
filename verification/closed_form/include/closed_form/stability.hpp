// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "closed_form/common.hpp"
#include "closed_form/membrane.hpp"

/// Closed forms of stability limits: central difference, triangle elements, enclosed gas, vents. All
/// functions throw std::invalid_argument, naming the field, for a parameter that is missing or out of
/// validity.
namespace closed_form {

/// Central difference of one undamped mode, W = omega dt > 0. Source: textbook result (T. J. R. Hughes, The
/// Finite Element Method).
struct CentralDifference {
  double frequency_ratio = 0.0;   // [-] omega_num/omega = 2 asin(W/2)/W; (pi/W) beyond W = 2
  double growth_per_step = 1.0;   // [-] |z|: 1 up to W = 2, then W^2/2 - 1 + sqrt((W^2/2 - 1)^2 - 1)
  double energy_amplitude = 0.0;  // [-] W^2/4, relative excess of the energy with averaged velocity
};
/// Results at W = omega_dt > 0 [-].
CentralDifference central_difference(double omega_dt);
/// Critical time step 2/omega [s].
double critical_time_step(double angular_frequency);

/// Greatest angular eigenfrequency [rad/s] of one free constant-strain triangle with mass rho t A/3 a node:
/// omega^2 = (3/rho) lambda_max(D B B^T). Corners (0, 0), (base, 0), (apex, height) [m]; base, height > 0.
/// Source: derived here.
double triangle_frequency(const Sheet& sheet, double base, double apex, double height);
/// The same for an equilateral triangle of side a [m]: omega^2 = 6 E/(rho (1-nu) a^2).
double equilateral_triangle_frequency(const Sheet& sheet, double side);
/// The same for a right isosceles triangle with legs a [m]: omega^2 = (3/(rho a^2))
/// ((k+2G) + sqrt((k+2G)^2 - 6 k G)), k = E/(1-nu).
double right_triangle_frequency(const Sheet& sheet, double leg);
/// The same for an unbounded mesh of equilateral triangles (Bloch wave at the M point): omega^2 = 16 E/(3 rho
/// (1-nu^2) a^2).
double equilateral_mesh_frequency(const Sheet& sheet, double side);
/// The same for an unbounded mesh of right isosceles triangles with legs a and uniform diagonals ((pi,pi)
/// wave): omega^2 = 8 E/(rho (1-nu^2) a^2). As for the equilateral mesh, the step limit is exactly the
/// smallest altitude over the plane-wave speed.
double right_mesh_frequency(const Sheet& sheet, double leg);

/// Gas enclosed by a membrane of uniform area density that moves normally.
struct EnclosedGas {
  PerfectGas gas;                   // in the bag
  double pressure = kRequired;      // [Pa] absolute, > 0
  double volume = kRequired;        // [m3] > 0
  double area = kRequired;          // [m2] of the surface, > 0
  double area_density = kRequired;  // [kg/m2] rho h > 0
};
/// Angular frequency sqrt(gamma p A/(V rho h)) [rad/s]. Exact for the rank-one gas stiffness on a smooth
/// closed surface; an upper bound on a folded bag. Source: derived here.
double gas_breathing_frequency(const EnclosedGas& bag);

/// Greatest |z| per step if the gas pressure lags the shape by one step:
///   z^2 - (2 - W_s^2) z + (1 + W_g^2) = 0, W_s = omega_structure dt, W_g = omega_gas dt, both >= 0.
/// sqrt(1 + W_g^2) while oscillating (M.20): unstable at every dt. Source: derived here.
double lagged_pressure_growth(double omega_structure_dt, double omega_gas_dt);

/// Drift of ln(p V^gamma) [-] in one step of Euler, E -= p dV, with relative volume change delta = dV/V.
/// Leading term -gamma (gamma-1) delta^2/2 (G.20). Needs -1 < delta < 1/(gamma-1). Source: derived here.
double euler_volume_work_drift(double heat_capacity_ratio, double delta);
/// The same with the mean of both pressures. Leading term -gamma (gamma^2-1) delta^3/12. Needs
/// -2/(gamma+1) < delta < 2/(gamma-1). Source: derived here.
double trapezoid_volume_work_drift(double heat_capacity_ratio, double delta);

/// Vent near equalisation: d sqrt(dp)/dt = -kappa.
struct VentEqualisation {
  PerfectGas gas;                       // in the vessel, near ambient pressure
  double volume = kRequired;            // [m3] > 0
  double area = kRequired;              // [m2] Cd A > 0
  double ambient_pressure = kRequired;  // [Pa] > 0
  double temperature = kRequired;       // [K] > 0
};
/// Rate kappa = gamma p_a A/(V sqrt(2 rho)) [sqrt(Pa)/s], rho = p_a/(R T). Source: derived here.
double vent_equalisation_rate(const VentEqualisation& vent);
/// Eigenvalue lambda = -kappa/sqrt(dp) [1/s] at overpressure dp > 0 [Pa].
double vent_eigenvalue(const VentEqualisation& vent, double overpressure);
/// Amplitude (kappa dt)^2 [Pa] of the final 2-cycle of explicit Euler (G.21).
double vent_chatter_amplitude(const VentEqualisation& vent, double time_step);

/// Explicit step limit [s] of penalty contact on one node, 2 sqrt(rho h A/k): tributary area A [m2],
/// stiffness k [N/m]. Source: textbook result.
double node_contact_time_step(const Sheet& sheet, double tributary_area, double stiffness);

}  // namespace closed_form
