// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "closed_form/common.hpp"

/// Closed forms of one uniform gas volume: filling, mixing, compression. All functions throw
/// std::invalid_argument, naming the field, for a parameter that is missing or out of validity.
namespace closed_form {

/// Rigid adiabatic tank filled at constant mass flow and inflow temperature.
struct TankFill {
  PerfectGas gas;                          // of tank and inflow
  double volume = kRequired;               // [m3] > 0
  double initial_pressure = kRequired;     // [Pa] >= 0; 0: evacuated
  double initial_temperature = kRequired;  // [K] > 0
  double mass_flow = kRequired;            // [kg/s] >= 0
  double inflow_temperature = kRequired;   // [K] > 0
};

/// State at `time` [s] >= 0: p = p0 + gamma R T_in mdot t / V, m = m0 + mdot t, T = p V / (m R). From an
/// evacuated tank T = gamma T_in for every t > 0; at t = 0 that limit is returned. Source: energy balance of
/// an open system, textbook result (tank filling).
GasState tank_fill(const TankFill& tank, double time);

/// Rigid adiabatic tank filled by a pulse, 0 <= t <= t_e:
///   mdot = (2 M / t_e) sin^2(pi t / t_e), T_in = T1 + (T2 - T1) t / t_e.
struct PulseFill {
  PerfectGas gas;                          // of tank and inflow
  double volume = kRequired;               // [m3] > 0
  double initial_pressure = kRequired;     // [Pa] > 0
  double initial_temperature = kRequired;  // [K] > 0
  double total_mass = kRequired;           // [kg] M > 0
  double duration = kRequired;             // [s] t_e > 0
  double start_temperature = kRequired;    // [K] T1 > 0
  double end_temperature = kRequired;      // [K] T2 > 0
};

/// Inflow and rate of the tank pressure at one time of the pulse.
struct PulseFlow {
  double mass_flow = 0.0;      // [kg/s]
  double temperature = 0.0;    // [K] of the inflow
  double pressure_rate = 0.0;  // [Pa/s] gamma R mdot T_in / V
};

/// State at `time` [s]; constant after t_e. With x = t/t_e:
///   int mdot = 2 M (x/2 - sin(2 pi x)/(4 pi)),
///   int mdot T_in = T1 int mdot + (T2 - T1) 2 M (x^2/4 - x sin(2 pi x)/(4 pi) - (cos(2 pi x) - 1)/(8 pi^2)),
///   p = p0 + gamma R int mdot T_in / V.
/// Source: derived here from the tank's energy balance.
GasState pulse_fill(const PulseFill& pulse, double time);

/// Flow of the pulse at `time` [s]; zero outside (0, t_e).
PulseFlow pulse_flow(const PulseFill& pulse, double time);

/// A mass of gas B at T_B enters a rigid adiabatic tank that holds gas A.
struct TwoGasFill {
  PerfectGas tank_gas;                       // gas A
  PerfectGas inflow_gas{2077.1, 5.0 / 3.0};  // gas B; default helium
  double volume = kRequired;                 // [m3] > 0
  double initial_pressure = kRequired;       // [Pa] > 0
  double initial_temperature = kRequired;    // [K] > 0
  double inflow_mass = kRequired;            // [kg] >= 0
  double inflow_temperature = kRequired;     // [K] > 0
};

/// State of the mixture after the fill.
struct TwoGasState {
  GasState state;                    // of the mixture
  double heat_capacity_ratio = 0.0;  // [-] sum(m cp) / sum(m cv); not the mean of gamma by mass
  double gas_constant = 0.0;         // [J/(kg K)] of the mixture
};

/// Mixture: (m_A cv_A + m_B cv_B) T = m_A cv_A T0 + m_B cp_B T_B, p = (m_A R_A + m_B R_B) T / V. Source:
/// derived here from the energy balance of an ideal mixture.
TwoGasState two_gas_fill(const TwoGasFill& tank);

/// Steady state of a rigid tank with constant inflow and a choked vent.
struct VentedFill {
  PerfectGas gas;                         // of tank and inflow
  double volume = kRequired;              // [m3] > 0
  double mass_flow = kRequired;           // [kg/s] > 0
  double inflow_temperature = kRequired;  // [K] > 0
  double vent_area = kRequired;           // [m2] > 0
  double discharge_coefficient = 1.0;     // [-] 0 < Cd <= 1
  double ambient_pressure = 101325.0;     // [Pa] >= 0, low enough that the vent is choked
};

/// The steady state, and the rates at which it is approached.
struct VentedFillSteady {
  GasState state;                // T = T_in, p = mdot sqrt(R T_in) / (Cd A phi)
  double slow_eigenvalue = 0.0;  // [1/s] < 0, of the linearised (m, U) system
  double fast_eigenvalue = 0.0;  // [1/s] < slow_eigenvalue
};

/// Steady state and eigenvalues (mdot/m_ss) (-(1 + 3 gamma)/2 +- sqrt((1 + 3 gamma)^2/4 - 4 gamma))/2.
/// Refused if the steady vent is not choked. Source: derived here by linearisation.
VentedFillSteady vented_fill_steady(const VentedFill& tank);

/// Gas in a cylinder that is compressed or expanded without heat flow: p V^gamma is constant.
struct AdiabaticPiston {
  PerfectGas gas;                          // in the cylinder
  double initial_pressure = kRequired;     // [Pa] > 0
  double initial_temperature = kRequired;  // [K] > 0
  double initial_volume = kRequired;       // [m3] > 0
};

/// State of the gas at one volume.
struct PistonState {
  GasState state;            // at that volume
  double work_on_gas = 0.0;  // [J] (p V - p0 V0) / (gamma - 1)
};

/// State at `volume` [m3] > 0. Source: reversible adiabatic process, textbook result.
PistonState adiabatic_piston(const AdiabaticPiston& piston, double volume);

/// Filling of a volume that grows at constant pressure.
struct ConstantPressureFill {
  PerfectGas gas;                          // of volume and inflow
  double pressure = kRequired;             // [Pa] > 0
  double initial_volume = kRequired;       // [m3] > 0
  double initial_temperature = kRequired;  // [K] > 0
  double mass_flow = kRequired;            // [kg/s] >= 0
  double inflow_temperature = kRequired;   // [K] > 0
};

/// State at `time` [s]: V = V0 + mdot R T_in t / p; T mixes by enthalpy. Source: derived here; textbook
/// result.
GasState constant_pressure_fill(const ConstantPressureFill& bag, double time);

/// Bag behind a linear spring: V = V0 + k (p - p0).
struct SpringBag {
  PerfectGas gas;                          // of bag and inflow
  double initial_pressure = kRequired;     // [Pa] > 0
  double initial_temperature = kRequired;  // [K] > 0
  double initial_volume = kRequired;       // [m3] > 0
  double compliance = kRequired;           // [m3/Pa] k >= 0
};

/// State after `mass` [kg] at `temperature` [K] has flowed in without heat flow or loss, at any speed:
///   (p V - p0 V0)/(gamma - 1) + k (p^2 - p0^2)/2 = m cp T.
/// Source: derived here from the energy balance.
GasState spring_bag_fill(const SpringBag& bag, double mass, double temperature);

}  // namespace closed_form
