// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "tank_gas.hpp"

namespace gas {

/// Smoothed pressures at the times of the result.
struct Pressures {
  std::vector<double> tank;     // [Pa]
  std::vector<double> rate;     // [Pa/s] of the tank
  std::vector<double> chamber;  // [Pa], empty for average temperature
};

/// Which points carry flow, and at which of them it is well determined.
struct Burn {
  std::size_t first = 0, last = 0;  // flow is zero outside
  std::vector<char> masked;
};

/// Flow and temperature at the times of the result.
struct Flow {
  std::vector<double> mass_flow;    // [kg/s]
  std::vector<double> temperature;  // [K] T_s
  double mean_temperature = 0.0;    // [K]
  double effective_area = 0.0;      // [m2]
};

/// One inversion of given pressures; no statistics.
class Inversion {
 public:
  Inversion(const TankTest& test, std::span<const double> times, const Pressures& pressures);

  /// K [kg K/s] at every point with gamma R of the inflator's gas at `temperature`, (G.34).
  std::vector<double> enthalpy_flow(double temperature) const;
  /// (G.35) over the whole record, as if nothing were masked, or over the burn. Throws DomainError.
  Flow average_temperature(const Burn& burn) const;
  /// (G.36), started from `guess`. Throws DomainError.
  Flow dual_pressure(const Burn& burn, const Flow& guess) const;
  TankGas::Range temperatures() const { return gas_.temperatures(); }

 private:
  std::vector<double> masses(const std::vector<double>& mass_flow) const;
  TankGas::Rate rate(std::size_t i, double mass) const;
  std::vector<double> solved_temperatures(const Burn& burn, const std::vector<double>& mass,
                                          const Flow& flow) const;
  std::vector<double> held(const Burn& burn, std::vector<double> temperature) const;
  bool unresolved(const Burn& burn, double temperature, std::size_t i) const;
  bool settle(const Burn& burn, std::vector<double>& mass, Flow& flow, double& ratio) const;

  const TankTest& test_;
  std::span<const double> times_;
  const Pressures& pressures_;
  TankGas gas_;
};

}  // namespace gas
