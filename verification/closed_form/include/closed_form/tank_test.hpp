// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "closed_form/common.hpp"

/// Synthetic tank tests: readings of the gauges in tank and chamber for a known pulse.
namespace closed_form {

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
