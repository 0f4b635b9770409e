// SPDX-License-Identifier: Apache-2.0
// A jet at the peak of its inflator's mass flow, and warnings of likely slips.
#pragma once

#include "engine/scene.hpp"

namespace driver {

struct JetPeak {
  double time = 0.0;       // [s]
  double mass_flow = 0.0;  // [kg/s]
  jet::OutletState outlet;
  double sonic_pressure = 0.0;  // [Pa] pe, of a sonic outlet whatever the law
};

/// The outlet at the inflator's greatest mass flow up to the scene's end (0 if it begins later), with ambient
/// pressure in the bag.
JetPeak jet_peak(const Scene& scene, const JetPart& part);

/// Share [-] of the gas that leaves a sonic outlet of that area below ambient pressure (K.34), by the
/// midpoint rule.
double below_sonic_share(const Scene& scene, const JetPart& part);

/// Momentum flux of a jet with spread = "cone" at `distance` [m], relative to the outlet [-]. By (J.5) it is
/// (width / R)^2 for a round jet and width / b for a rectangular one.
double cone_gain(const jet::JetModel& cone, double distance);

/// Adds warnings of jets: outlets that cannot blow into the bag, rays that start outside it. It tests many
/// rays, which takes longer than reading the scene.
void add_jet_warnings(Scene& scene);

}  // namespace driver
