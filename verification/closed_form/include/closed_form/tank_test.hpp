// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "closed_form/common.hpp"

/// Tank tests: flow and temperature from readings, and readings of tank and chamber for a known pulse. All
/// functions throw std::invalid_argument, naming the field, for a parameter that is missing or out of
/// validity.
namespace closed_form {

/// Tank test with measured end pressure and known total mass.
struct AverageTemperature {
  PerfectGas gas;                       // of tank and inflow
  double volume = kRequired;            // [m3] > 0
  double initial_pressure = kRequired;  // [Pa] >= 0
  double final_pressure = kRequired;    // [Pa] > initial_pressure
  double total_mass = kRequired;        // [kg] > 0
};
/// Mean inflow temperature T_bar = (p_end - p0) V / (gamma R M) [K]. Source: tank_fill, solved for T_in.
double average_inflow_temperature(const AverageTemperature& tank);

/// Mass flow V (dp/dt) / (gamma R T_bar) [kg/s], for `pressure_rate` dp/dt [Pa/s]. Exact for the product mdot
/// T_in; mdot itself is off by the factor T_in/T_bar.
double average_temperature_mass_flow(const AverageTemperature& tank, double pressure_rate);

/// Dual-pressure tank test: choked inflator outlet; chamber pressure and rate of the tank pressure are
/// measured.
struct DualPressure {
  PerfectGas gas;                       // of inflator and tank
  double volume = kRequired;            // [m3] of the tank, > 0
  double outlet_area = kRequired;       // [m2] Cd A > 0
  double chamber_pressure = kRequired;  // [Pa] > 0
  double pressure_rate = kRequired;     // [Pa/s] of the tank, > 0
};

/// Flow that follows from the two readings at one time.
struct DualPressureResult {
  double mass_flow = 0.0;    // [kg/s] (A phi p_c)^2 / (R Q), Q = V p' / (gamma R)
  double temperature = 0.0;  // [K] R Q^2 / (A phi p_c)^2, stagnation
};
/// Flow at one time. Source: derived here from the choked-flux formula and the tank's energy balance.
DualPressureResult dual_pressure(const DualPressure& test);

/// A pulse leaves a chamber through an outlet of effective area Cd A into a rigid adiabatic tank with gas of
/// its own: mdot = (2 M/t_e) sin^2(pi t/t_e), T_s = T1 + (T2 - T1) t/t_e.
struct TankTestPulse {
  double volume = kRequired;               // [m3] > 0
  double initial_pressure = kRequired;     // [Pa] > 0 of the tank's own gas
  double initial_temperature = kRequired;  // [K] > 0
  double total_mass = kRequired;           // [kg] M > 0
  double duration = kRequired;             // [s] t_e > 0
  double start_temperature = kRequired;    // [K] T1 > 0, stagnation temperature in the chamber
  double end_temperature = kRequired;      // [K] T2 > 0
  double outlet_area = kRequired;          // [m2] Cd A > 0
};

/// Readings at one time, and the flow behind them.
struct TankTestReadings {
  double tank_pressure = 0.0;  // [Pa]
  /// [Pa] That of the tank if nothing flows.
  double chamber_pressure = 0.0;
  double mass_flow = 0.0;    // [kg/s]
  double temperature = 0.0;  // [K] T_s
};

/// Readings at `time` [s], constant after t_e, for gases of constant cp: (m_A cv_A + m cv_B) T = m_A cv_A
/// T0 + cp_B int mdot T_s dt. Source: energy balance of an open system; derived here.
TankTestReadings tank_test_pulse(const PerfectGas& tank_gas, const PerfectGas& inflow_gas,
                                 const TankTestPulse& pulse, double time);

/// Pressure [Pa] upstream of an outlet that drives mdot through it against p_t. With q = (gamma-1)/(2 gamma)
/// R T (mdot/(A p_t))^2 the isentropic relation is y^2 - y = q, y = (p_c/p_t)^((gamma-1)/gamma), as long as
/// y <= (gamma+1)/2. Beyond, the outlet is choked: p_c = mdot sqrt(R T)/(A phi). Source: derived here from
/// isentropic flow.
double chamber_pressure(const PerfectGas& gas, double outlet_area, double mass_flow, double temperature,
                        double tank_pressure);

/// A species with NASA-7 coefficients, and its share of the mass.
struct Nasa7Share {
  double mass_fraction;        // [-]
  double gas_constant;         // [J/(kg K)]
  std::array<double, 7> low;   // to 1000 K
  std::array<double, 7> high;  // from 1000 K on
};
/// Mixture; the mass fractions sum to 1.
using Nasa7Gas = std::vector<Nasa7Share>;

/// Specific enthalpy [J/kg] of the polynomials. Source: NASA TM-4513, 1993.
double nasa7_enthalpy(const Nasa7Gas& gas, double temperature);

/// The same pulse for gases with cp(T): U(T) = U0 + int mdot h(T_s) dt by Gauss quadrature, T by bisection
/// between 200 and 6000 K. The outlet has gamma at T_s.
TankTestReadings nasa7_tank_test_pulse(const Nasa7Gas& tank_gas, const Nasa7Gas& inflow_gas,
                                       const TankTestPulse& pulse, double time);

}  // namespace closed_form
