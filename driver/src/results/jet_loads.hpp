// SPDX-License-Identifier: Apache-2.0
// What all jets together do to each element of the skin.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "driver/state.hpp"

namespace driver {

struct JetLoads {
  std::vector<double> overpressure;  // [Pa]
  std::vector<std::uint8_t> mask;  // 0 no load, 1 in a jet but hidden or facing away, 2 lit, if only in part
};

inline JetLoads jet_loads(const State& state, std::size_t elements) {
  JetLoads loads{std::vector<double>(elements, 0.0), std::vector<std::uint8_t>(elements, 0)};
  for (const JetRun& run : state.jets)
    for (const int element : run.load().candidates) {
      const auto e = static_cast<std::size_t>(element);
      const double pressure = run.load().overpressure[e];
      loads.overpressure[e] += pressure;
      loads.mask[e] = std::max<std::uint8_t>(loads.mask[e], pressure > 0.0 ? 2 : 1);
    }
  return loads;
}

}  // namespace driver
