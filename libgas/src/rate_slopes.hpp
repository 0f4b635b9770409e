// SPDX-License-Identifier: Apache-2.0
// Derivatives of the rates at one state of the gas, and how fast the gas relaxes.
#pragma once
#include "balance.hpp"

namespace gas {

/// Overpressure [Pa] at which the flow of holes and fabric balances its feed; 0 if nothing feeds them.
double balanced_overpressure(const Balance& balance);

/// The gas at which to linearise: the present gas, or the gas at balanced_overpressure() if that is farther
/// from p_a. In between the law's slope varies, and p leaves that range at once.
UniformGas where_linear(const Balance& balance);

/// Relaxation rate [1/s] of the walls (G.16).
double wall_relaxation(const Balance& balance);
/// Relaxation rate [1/s] by walls and flow together: the faster one of (G.14), or the rate of p by backflow.
/// Returns a cheap upper bound instead if that is at most `enough`.
double relaxation(const Balance& balance, double enough = 0.0);

/// Derivatives of the rates of a Balance. The gas has parts z: the mass of each species, which comes at the
/// gas's own temperature, and last the energy (G.23).
class RateSlopes {
 public:
  explicit RateSlopes(const Slots& slots);
  /// Computes them for the gas that `balance` has located.
  void fill(const Balance& balance);

  std::vector<Vector> by_part;  // [part] d(dy/dt)/dz
  Vector by_time;               // d(dy/dt)/dt with the gas held
  /// [J/kg] energy that comes with 1 kg of each species.
  Vector part_energy;

 private:
  enum Variable { kPressure, kTemperature, kGasConstant, kGamma, kTime, kVariables };
  using Number = Dual<kVariables>;
  /// Derivatives of the variables, and of h.
  struct Change {
    std::array<double, kVariables> variables;
    double enthalpy;
  };

  void fill_changes(const Balance& balance, const UniformGas& gas);

  std::vector<Change> changes_;  // by each part, and last by time
};

}  // namespace gas
