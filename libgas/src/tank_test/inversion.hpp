// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "tank_gas.hpp"

namespace gas {

/// Smoothed pressures at the times of the result.
struct Pressures {
  std::vector<double> tank;  // [Pa]
  std::vector<double> rate;  // [Pa/s] of the tank
  /// [Pa/s] at which the tank's would rise without heat loss: shows where gas flows.
  std::vector<double> adiabatic_rate;
  std::vector<double> chamber;  // [Pa], empty for average temperature
  double initial = 0.0;         // [Pa] of the tank before firing
  double conductance = 0.0;     // [W/K] of the walls
};

/// Points with flow, and points at which the flow is well determined.
struct Burn {
  std::size_t first = 0, last = 0;  // the flow is zero outside
  std::size_t end = 0;              // from here on the tank holds all of the mass
  std::vector<char> masked;
  std::vector<char> clipped;  // the chamber gauge is cut off, its pressure unknown
  /// Not masked and well determined. Other points take their temperature from these.
  std::vector<char> firm;
  /// Factors of the constant temperatures before the first and after the last firm point.
  double before = 1.0, after = 1.0;
};

/// Flow and temperature at the times of the result.
struct FlowCurves {
  std::vector<double> mass_flow;    // [kg/s]
  std::vector<double> temperature;  // [K] T_s
  double mean_temperature = 0.0;    // [K]
  double effective_area = 0.0;      // [m2]
};

/// A first guess of the mass [kg] in the tank: it grows as the pressure up to its peak.
std::vector<double> masses_of_rise(const TankTest& test, const Pressures& pressures);
/// Sets the adiabatic rate, given the mass [kg] in the tank at each point.
void set_adiabatic_rate(const TankTest& test, std::span<const double> masses, Pressures& pressures);

/// R.m.s. distance, in ln T, of the firm temperatures from the first and from the last of them. It is the
/// uncertainty of the constant temperatures outside.
struct HeldSpread {
  double before = 0.0, after = 0.0;
};
HeldSpread held_spread(const Burn& burn, std::span<const double> temperature);

/// One inversion of given pressures, without statistics.
class Inversion {
 public:
  Inversion(const TankTest& test, std::span<const double> times, const Pressures& pressures);

  /// Mass [kg] delivered up to each point.
  std::vector<double> masses(const std::vector<double>& mass_flow) const;
  /// K [kg K/s] at every point (G.34), with gamma R of the inflator's gas at `temperature` [K].
  std::vector<double> enthalpy_flow(double temperature) const;
  /// Average-temperature method (G.35). Throws DomainError.
  FlowCurves average_temperature(const Burn& burn) const;
  /// Dual-pressure method (G.36), started from `guess`, whose flow has the known mass. Throws DomainError.
  FlowCurves dual_pressure(const Burn& burn, const FlowCurves& guess) const;

 private:
  std::vector<double> heat_lost(const std::vector<double>& masses) const;
  TankGas::Rate rate(std::size_t i, double mass) const;
  double guessed_area(double temperature) const;
  std::vector<double> held(const Burn& burn, std::vector<double> temperature) const;
  void solve(const Burn& burn, const std::vector<double>& mass, FlowCurves& flow) const;
  void scale_to_mass(const Burn& burn, std::vector<double>& mass_flow) const;

  const TankTest& test_;
  std::span<const double> times_;
  const Pressures& pressures_;
  TankGas gas_;
};

}  // namespace gas
