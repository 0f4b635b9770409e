// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "closed_form/common.hpp"

/// Closed forms of one gas volume that exchanges heat or ambient gas with its surroundings. All functions
/// throw std::invalid_argument, naming the field, for a parameter that is missing or out of validity.
namespace closed_form {

/// Rigid adiabatic tank below ambient pressure. Ambient gas fills it through a hole. Tank gas and ambient gas
/// are the same.
struct AmbientInrush {
  PerfectGas gas;                          // of tank and ambient
  double volume = kRequired;               // [m3] > 0
  double area = kRequired;                 // [m2] Cd A > 0
  double initial_pressure = kRequired;     // [Pa] 0 <= p0 < ambient_pressure; 0: evacuated
  double initial_temperature = kRequired;  // [K] > 0
  double ambient_pressure = kRequired;     // [Pa] > 0
  double ambient_temperature = kRequired;  // [K] > 0
};

/// State at `time` [s] >= 0, from dp/dt = gamma R T_a mdot(p)/V. While sonic, p is linear in time. Subsonic,
/// with p = p_a s^(gamma/(gamma-1)), the powers cancel: sqrt(1 - s) falls linearly in time, to 0 at a finite
/// end. p - p0 = gamma R T_a (m - m0)/V, so an evacuated tank ends at T = gamma T_a. The state is constant
/// after the end. Source: derived here.
GasState ambient_inrush(const AmbientInrush& tank, double time);
/// Time [s] at which the tank reaches ambient pressure.
double ambient_inrush_end(const AmbientInrush& tank);

/// Rigid tank that is filled at constant mass flow and inflow temperature and loses heat h A (T - T_ext).
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

/// State at `time` [s] >= 0: T - T_inf = (T0 - T_inf)(1 + mdot t/m0)^-(1 + hA/(mdot cv)), with T_inf = (mdot
/// cp T_in + hA T_ext)/(mdot cv + hA). Without inflow: exponential of rate hA/(m0 cv). Source: linear energy
/// balance, derived here.
GasState heat_loss_fill(const HeatLossFill& tank, double time);

/// Rigid adiabatic tank that leaks through fabric with velocity v = k (p - p_a): mdot = C rho v.
struct LinearFabricTank {
  PerfectGas gas;                          // in the tank
  double volume = kRequired;               // [m3] > 0
  double area = kRequired;                 // [m2] C > 0
  double permeability = kRequired;         // [m/(s Pa)] k > 0
  double initial_pressure = kRequired;     // [Pa] > ambient_pressure
  double initial_temperature = kRequired;  // [K] > 0
  double ambient_pressure = kRequired;     // [Pa] > 0
};

/// State at `time` [s] >= 0: p = p_a/(1 - (1 - p_a/p0) exp(-gamma k C p_a t/V)), isentropic. Source: derived
/// here (p obeys the logistic equation).
GasState linear_fabric_tank(const LinearFabricTank& tank, double time);

}  // namespace closed_form
