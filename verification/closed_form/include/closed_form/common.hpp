// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace closed_form {

/// Default of a field that must be given: every function refuses it by name (std::invalid_argument).
inline constexpr double kRequired = std::numeric_limits<double>::quiet_NaN();

/// Perfect gas with constant heat capacities. The default is nitrogen, as in the reference cases.
struct PerfectGas {
  double gas_constant = 296.8;       // [J/(kg K)] R > 0
  double heat_capacity_ratio = 1.4;  // [-] gamma, 1 < gamma < 3
};

/// Heat capacity at constant pressure, gamma R / (gamma - 1) [J/(kg K)].
double specific_heat_cp(const PerfectGas& gas);

/// Heat capacity at constant volume, R / (gamma - 1) [J/(kg K)].
double specific_heat_cv(const PerfectGas& gas);

/// Uniform state of a gas volume, p V = m R T.
struct GasState {
  double mass = 0.0;         // [kg]
  double temperature = 0.0;  // [K]
  double pressure = 0.0;     // [Pa] absolute
  double volume = 0.0;       // [m3]
};

}  // namespace closed_form
