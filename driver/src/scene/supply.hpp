// SPDX-License-Identifier: Apache-2.0
// What the inflators send in up to the end of a scene, triggers taken to fire at 0, and the volume that it
// fills.
#pragma once

#include "driver/forecast.hpp"

namespace driver {

/// Seconds of an inflow's own time that the scene sees.
double duration(const Scene& scene, const gas::Inflow& inflow);

struct Corner {
  double time;     // [s]
  gas::Side side;  // on which its flow is a limit
};

/// The ends of the pieces, up to the scene's end, on which its flow is linear; empty if it begins later.
std::vector<Corner> corners(const Scene& scene, const gas::Inflow& inflow);

Supply supply_of(const Scene& scene);

FullState full_state(const Scene& scene, const State& state, const Supply& supply);

}  // namespace driver
