// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "gas/integrator.hpp"

// Gases and tanks shared by the tests of libgas.
namespace cases {

inline constexpr double kAmbientPressure = 101325.0;  // [Pa]
inline constexpr double kEpsilon = 2.220446049250313e-16;
inline constexpr gas::Method kMethods[] = {gas::Method::dormand_prince_5, gas::Method::runge_kutta_4,
                                           gas::Method::euler, gas::Method::rosenbrock_4};
inline const std::vector<double> kPure{1.0};  // mass fractions of a mixture of one species

/// The verification gas: gamma = 7/5 exactly.
inline gas::Thermo nitrogen() {
  return gas::Thermo({gas::constant_cp_species("N2", 296.8, 1038.8)});
}

inline gas::Thermo nasa7(const std::vector<std::string>& names) {
  std::vector<gas::Species> species;
  for (const std::string& name : names) species.push_back(gas::nasa7_species(name));
  return gas::Thermo(species);
}

inline gas::ControlVolumeModel closed_tank(const gas::Thermo& thermo) {
  return {thermo, {kAmbientPressure, 293.15}, {}, {}};
}

/// Constant `mass_flow` [kg/s] of the first species at `temperature` [K].
inline gas::Inflow steady_inflow(const gas::Thermo& thermo, double mass_flow, double temperature) {
  std::vector<double> fractions(thermo.size(), 0.0);
  fractions[0] = 1.0;
  return {fractions, gas::Curve::constant(mass_flow), gas::Curve::constant(temperature)};
}

/// Overpressure [Pa] at which laminar flow, (G.22), is what the law of the root gives at `inviscid` [Pa].
inline double laminar(double inviscid) {
  const double d = 1e-8 * kAmbientPressure;
  double low = inviscid, high = inviscid + 2.0 * d;
  for (int i = 0; i < 200; ++i) {
    const double dp = 0.5 * (low + high);
    (dp * dp / std::pow(dp * dp + d * d, 0.75) < std::sqrt(inviscid) ? low : high) = dp;
  }
  return low;
}

inline gas::VolumePath rigid(double volume, double leak_area = 0.0) {
  return {volume, volume, leak_area, leak_area};
}

inline double relative(double value, double expected) {
  return std::abs(value / expected - 1.0);
}

}  // namespace cases
