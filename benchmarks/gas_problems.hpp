// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "second_route.hpp"

// Tanks for work against precision of the gas.
namespace benchmarks {

struct PressureTemperature {
  double pressure;     // [Pa]
  double temperature;  // [K]
};

struct GasProblem {
  std::string name;
  second_route::Tank tank;
  std::vector<double> observed;  // [s] of the tank's stops, where the error is taken; the last is the end
  /// Closed form at an observed time; empty where there is none.
  std::function<PressureTemperature(double time)> exact{};
  bool of_overpressure = false;  // the error of p is relative to p - p_a, else to p
};

/// Filled and sealed, filled and vented, choked blow-down, equalisation, tiny volume, three pulses.
std::vector<GasProblem> gas_problems();

/// p and T of the gas of a state of that tank.
PressureTemperature observe(const second_route::Tank& tank, const gas::ControlVolumeState& state,
                            double time);

}  // namespace benchmarks
