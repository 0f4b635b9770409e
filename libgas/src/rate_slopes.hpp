// SPDX-License-Identifier: Apache-2.0
// The balance near one gas: how its rates follow it, and how fast it relaxes.
#pragma once
#include "balance.hpp"

namespace gas {

/// Overpressure [Pa] at which the flow of holes and fabric balances its feed; 0 if nothing feeds them.
double balanced_overpressure(const Balance& balance);

/// The gas at which to linearise. If the overpressure at which flow balances its feed is farther from p_a,
/// the gas is taken there: in between the law has another slope at each place, and p leaves that range at
/// once.
UniformGas where_linear(const Balance& balance);

/// Relaxation rate [1/s] of the walls (G.16).
double wall_relaxation(const Balance& balance);
/// The same of walls and flow together: the faster of (G.14), or that of p by backflow. If a cheap bound of
/// it is at most `enough`, that bound.
double relaxation(const Balance& balance, double enough = 0.0);

/// Derivatives of the rates of a Balance. The gas has parts z: the mass of each species, taken to come at the
/// gas's own temperature, and last its energy (G.23).
class RateSlopes {
 public:
  explicit RateSlopes(const Slots& slots);
  /// For the gas that `balance` has located.
  void fill(const Balance& balance);

  std::vector<Vector> by_part;  // [part] d(dy/dt)/dz
  Vector by_time;               // d(dy/dt)/dt with the gas held
  /// [J/kg] Energy that comes with 1 kg of each species.
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
