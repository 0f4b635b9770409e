// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "closed_form/common.hpp"

/// Closed forms of outflow: orifice and porous fabric, and tanks that empty through them. All functions throw
/// std::invalid_argument, naming the field, for a parameter that is missing or out of validity.
namespace closed_form {

/// Critical pressure ratio r* = (2/(gamma+1))^(gamma/(gamma-1)) [-], 1 < gamma < 3. Source: isentropic nozzle
/// flow, textbook result.
double critical_pressure_ratio(double heat_capacity_ratio);

/// Choked flux coefficient phi = sqrt(gamma) (2/(gamma+1))^((gamma+1)/(2(gamma-1))) = mdot sqrt(R T) / (A p)
/// [-].
double choked_flux_coefficient(double heat_capacity_ratio);

/// Sharp-edged hole in a vessel.
struct Orifice {
  PerfectGas gas;                       // in the vessel
  double area = kRequired;              // [m2] > 0
  double discharge_coefficient = 1.0;   // [-] 0 < Cd <= 1
  double pressure = kRequired;          // [Pa] inside, > 0
  double temperature = kRequired;       // [K] inside, > 0
  double ambient_pressure = kRequired;  // [Pa] >= 0
};

/// Mass flow [kg/s], 0 if p_a >= p:
///   mdot = Cd A p / sqrt(R T) sqrt(2 gamma/(gamma-1) (r^(2/gamma) - r^((gamma+1)/gamma))), r = max(p_a/p,
///   r*).
/// Computed without cancellation for p_a -> p (expm1, log1p). Source: isentropic nozzle flow, textbook
/// result.
double orifice_mass_flow(const Orifice& orifice);
/// The same at p - p_a [Pa], to all digits also where p would round to p_a; orifice.pressure is not read.
double orifice_mass_flow(Orifice orifice, double overpressure);

/// Overpressure p - p_a above which the hole is choked, p_a (1/r* - 1) [Pa].
double choking_overpressure(double heat_capacity_ratio, double ambient_pressure);

/// Mass flow of the hole over A sqrt(2 rho dp) [-], rho upstream; epsilon = dp/p in (0, 1 - r*].
double bernoulli_ratio(double heat_capacity_ratio, double epsilon);

/// Series of the same, 1 - 3 epsilon/(4 gamma) - (40 gamma - 29) epsilon^2/(96 gamma^2); remainder
/// O(epsilon^3).
double bernoulli_ratio_series(double heat_capacity_ratio, double epsilon);

/// Law by which the porosity eta gives the leak area.
enum class PorosityLaw {
  printed,  // eta^2 A, the formula as printed in "Gas Jet Model for Airbag Inflators"
  screen,   // eta A, a resistance coefficient 1/eta^2 as that text says
};

/// Leak area C [m2]: eta^2 A (printed) or eta A (screen); 0 <= eta <= 1, A >= 0 [m2].
double leak_area(double porosity, double fabric_area, PorosityLaw law = PorosityLaw::printed);

/// Porous fabric with gas under pressure behind it.
struct PorousFabric {
  PerfectGas gas;                          // behind the fabric
  double porosity = kRequired;             // [-] 0 <= eta <= 1
  double fabric_area = kRequired;          // [m2] >= 0
  PorosityLaw law = PorosityLaw::printed;  // of the leak area
  double pressure = kRequired;             // [Pa] inside, > 0
  double temperature = kRequired;          // [K] inside, > 0
  double ambient_pressure = kRequired;     // [Pa] >= 0
};

/// Mass flow C sqrt(2 rho (p - p_a)) [kg/s], rho = p/(R T); 0 if p_a >= p.
double porous_mass_flow(const PorousFabric& fabric);
/// The same at p - p_a [Pa], to all digits also where p would round to p_a; fabric.pressure is not read.
double porous_mass_flow(PorousFabric fabric, double overpressure);

/// Rigid tank that empties through a hole into the ambient gas.
struct Blowdown {
  PerfectGas gas;                          // in the tank
  double volume = kRequired;               // [m3] > 0
  double area = kRequired;                 // [m2] > 0
  double discharge_coefficient = 1.0;      // [-] 0 < Cd <= 1
  double initial_pressure = kRequired;     // [Pa] > ambient_pressure
  double initial_temperature = kRequired;  // [K] > 0
  double ambient_pressure = kRequired;     // [Pa] > 0
};

/// Instants of a blow-down. A tank that starts unchoked has unchoke_time = 0 and unchoke_pressure = p0.
struct BlowdownTimes {
  double time_constant = 0.0;      // [s] tau of the choked phase
  double unchoke_time = 0.0;       // [s]
  double unchoke_pressure = 0.0;   // [Pa]
  double end_time = 0.0;           // [s] when p reaches p_a; finite
  double final_temperature = 0.0;  // [K]
  double final_mass = 0.0;         // [kg]
};

/// State at `time` [s] >= 0, adiabatic (isentropic inside); constant after end_time.
/// - Choked: f = 1 + (gamma-1) t/(2 tau), T = T0 f^-2, p = p0 f^(-2 gamma/(gamma-1)).
/// - Subsonic: with y = T/T_f, mdot = K sqrt(y - 1) exactly. Hence t by int (1 + v^2)^b dv, v = sqrt(y - 1),
///   b = (2-gamma)/(gamma-1), inverted by Newton.
///
/// Source: derived here; the problem is the "free batch expansion" of transport-phenomena textbooks.
GasState blowdown(const Blowdown& tank, double time);
/// Instants of that blow-down.
BlowdownTimes blowdown_times(const Blowdown& tank);
/// Time [s] at which `pressure` [Pa] is reached, p_a <= pressure <= p0.
double blowdown_time_of_pressure(const Blowdown& tank, double pressure);

/// State at `time` [s] >= 0 for constant temperature. Choked: p = p0 exp(-t/tau). Subsonic: int (1 + v^2)^b
/// dv with b = 1/(gamma-1) - 1/2 (a polynomial for gamma = 7/5). Source: derived here.
GasState isothermal_blowdown(const Blowdown& tank, double time);
/// Instants of that blow-down; final_temperature is the initial one.
BlowdownTimes isothermal_blowdown_times(const Blowdown& tank);

/// State at `time` [s] >= 0 of a bag in place of the tank: V = V0 p/p0, `volume` is V0. Choked, mdot = mdot0
/// (p/p0)/sqrt(T/T0), and the gas that stays inside expands reversibly:
///   m/m0 = (1 - mdot0 t/(2 m0))^2 = (p/p0)^((gamma + 1)/gamma).
/// Needs a vent that is choked up to `time`; ambient_pressure may be 0. Source: derived here.
GasState proportional_blowdown(const Blowdown& bag, double time);

/// Rigid tank that empties through porous fabric, mdot = C sqrt(2 rho (p - p_a)).
struct PorousTank {
  PerfectGas gas;                          // in the tank
  double volume = kRequired;               // [m3] > 0
  double porosity = kRequired;             // [-] 0 < eta <= 1
  double fabric_area = kRequired;          // [m2] > 0
  PorosityLaw law = PorosityLaw::printed;  // of the leak area
  double initial_pressure = kRequired;     // [Pa] > ambient_pressure
  double initial_temperature = kRequired;  // [K] > 0
  double ambient_pressure = kRequired;     // [Pa] > 0
};

/// State at `time` [s] >= 0, isothermal, for any overpressure: p = p_a cosh^2(u0 - k t), k = C sqrt(R T/2)/V,
/// u0 = arcosh sqrt(p0/p_a); it ends at u0/k. Source: derived here.
GasState porous_tank_isothermal(const PorousTank& tank, double time);
/// Time [s] of that end.
double porous_tank_isothermal_end(const PorousTank& tank);

/// State at `time` [s] >= 0, adiabatic: t by int (1 + v^2)^b dv, v = sqrt(p/p_a - 1), b = 1/(2 gamma) - 1.
/// Source: derived here.
GasState porous_tank_adiabatic(const PorousTank& tank, double time);
/// Time [s] at which p reaches p_a.
double porous_tank_adiabatic_end(const PorousTank& tank);

/// Estimate of that time [s] for small overpressure, where dp = dp0 (1 - t/t_e)^2.
double porous_tank_parabola_end(const PorousTank& tank);

}  // namespace closed_form
