// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "closed_form/common.hpp"

// Closed forms of one gas volume that exchanges heat or ambient gas with its surroundings.
// All functions throw std::invalid_argument naming the field when a parameter is missing or out of validity.
namespace closed_form {

/// Rigid tank at rest below ambient pressure that fills through a hole with ambient gas, adiabatic; tank gas
/// and ambient gas are the same.
struct AmbientInrush {
  PerfectGas gas;                          // of tank and ambient
  double volume = kRequired;               // [m3] > 0
  double area = kRequired;                 // [m2] Cd A > 0
  double initial_pressure = kRequired;     // [Pa] 0 <= p0 < ambient_pressure; 0 is an evacuated tank
  double initial_temperature = kRequired;  // [K] > 0
  double ambient_pressure = kRequired;     // [Pa] > 0
  double ambient_temperature = kRequired;  // [K] > 0
};

/// dp/dt = gamma R T_a mdot(p)/V. Sonic: p linear in time. Subsonic: with p = p_a s^(gamma/(gamma-1)) the
/// powers cancel and sqrt(1 - s) falls linearly in time, to 0 at a finite end. p - p0 = gamma R T_a (m -
/// m0)/V, so an evacuated tank ends at T = gamma T_a. State constant after the end. Needs time >= 0 [s].
/// Source: derived here.
GasState ambient_inrush(const AmbientInrush& tank, double time);
double ambient_inrush_end(const AmbientInrush& tank);  // [s] when the tank is at ambient pressure

/// Rigid tank filled at constant mass flow and inflow temperature, which loses heat h A (T - T_ext).
struct HeatLossFill {
  PerfectGas gas;                          // of tank and inflow
  double volume = kRequired;               // [m3] > 0
  double initial_pressure = kRequired;     // [Pa] > 0
  double initial_temperature = kRequired;  // [K] > 0
  double mass_flow = kRequired;            // [kg/s] >= 0
  double inflow_temperature = kRequired;   // [K] > 0
  double conductance = kRequired;          // [W/K] h A >= 0
  double outside_temperature = kRequired;  // [K] > 0
};

/// T - T_inf = (T0 - T_inf)(1 + mdot t/m0)^-(1 + hA/(mdot cv)), T_inf = (mdot cp T_in + hA T_ext)/(mdot cv +
/// hA); without inflow the exponential of rate hA/(m0 cv). Needs time >= 0 [s]. Source: linear energy
/// balance, derived here.
GasState heat_loss_fill(const HeatLossFill& tank, double time);

/// Rigid adiabatic tank that leaks through fabric of velocity v = k (p - p_a): mdot = C rho v.
struct LinearFabricTank {
  PerfectGas gas;                          // in the tank
  double volume = kRequired;               // [m3] > 0
  double area = kRequired;                 // [m2] C > 0
  double permeability = kRequired;         // [m/(s Pa)] k > 0
  double initial_pressure = kRequired;     // [Pa] > ambient_pressure
  double initial_temperature = kRequired;  // [K] > 0
  double ambient_pressure = kRequired;     // [Pa] > 0
};

/// p = p_a/(1 - (1 - p_a/p0) exp(-gamma k C p_a t/V)), isentropic. Needs time >= 0 [s]. Source: derived here
/// (p obeys the logistic equation).
GasState linear_fabric_tank(const LinearFabricTank& tank, double time);

}  // namespace closed_form
