// SPDX-License-Identifier: Apache-2.0
// Load of all jets together on each element of the skin.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/state.hpp"

namespace driver {

struct JetLoads {
  std::vector<double> overpressure;  // [Pa]
  std::vector<std::uint8_t> mask;  // 0 outside or facing away, 1 in a jet but hidden, 2 lit, at least in part

  void add(std::size_t e, double pressure, std::uint8_t value) {
    overpressure[e] += pressure;
    mask[e] = std::max(mask[e], value);
  }
};

/// Calls `add(element, overpressure, mask)` for each element in each jet.
template <typename Add>
void add_jet_loads(const State& state, const Add& add) {
  for (const JetRun& run : state.jets)
    for (const int element : run.load().candidates) {
      const auto e = static_cast<std::size_t>(element);
      const double pressure = run.load().overpressure[e];
      add(e, pressure, static_cast<std::uint8_t>(pressure > 0.0 ? 2 : 1));
    }
}

inline JetLoads jet_loads(const State& state, std::size_t elements) {
  JetLoads loads{std::vector<double>(elements, 0.0), std::vector<std::uint8_t>(elements, 0)};
  add_jet_loads(state,
                [&](std::size_t e, double pressure, std::uint8_t mask) { loads.add(e, pressure, mask); });
  return loads;
}

}  // namespace driver
