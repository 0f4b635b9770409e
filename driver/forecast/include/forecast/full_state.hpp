// SPDX-License-Identifier: Apache-2.0
// The volume that the supply of a scene fills, and the gas in it.
#pragma once

#include "engine/state.hpp"
#include "engine/supply.hpp"

namespace driver {

/// Gas in the full volume, or at the start if nothing flows in. If the supply does not fill the volume, there
/// is no pressure of (K.31), and no group that uses it.
struct FullState {
  double volume = 0.0;           // [m3] as sewn, or at the start if larger
  double closed_pressure = 0.0;  // [Pa] pressure if nothing flowed out (K.30)
  /// True if the closed pressure is at least ambient, or nothing flows in.
  bool fills = true;
  /// [Pa] the closed pressure or, if lower, the pressure at which the openings let out the peak flow (K.31).
  double pressure = 0.0;
  double vent_flow = 0.0, fabric_flow = 0.0;  // [kg/s] at that pressure
  /// [1/s] faster relaxation rate of the outflow at that pressure (G.14).
  double relaxation = 0.0;
  double relaxations = 0.0;  // [-] number of relaxations in the whole scene (K.39)
  double gamma = 0.0;
};

FullState full_state(const Scene& scene, const State& state, const Supply& supply);

}  // namespace driver
