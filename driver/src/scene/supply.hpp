// SPDX-License-Identifier: Apache-2.0
// What the inflators send in up to the end of a scene, and the volume that it fills. Triggers are taken to
// fire at 0.
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

/// An inflator at its greatest mass flow up to the scene's end; that is 0 if it begins later.
struct InflatorPeak {
  double time = 0.0;  // [s]
  gas::InflatorPoint point{};
};
InflatorPeak inflator_peak(const Scene& scene, std::size_t inflator);

Supply supply_of(const Scene& scene);

FullState full_state(const Scene& scene, const State& state, const Supply& supply);

/// cp/cv of the gas at the start [-]. An empty volume has that of the gas that fills it; a scene without a
/// volume of gas has none, 0.
double gamma_at_start(const State& state, const Forecast& f);

}  // namespace driver
