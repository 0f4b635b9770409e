// SPDX-License-Identifier: Apache-2.0
// How much a jet pushes, and how far its model may be off (docs/theory/jet_push.md).
#pragma once

#include "engine/scene.hpp"

namespace driver {

/// A jet at its inflator's greatest mass flow, with ambient pressure in the bag.
struct JetPush {
  double pressure_ratio = 0.0;  // [-] pe / pa of a sonic outlet
  double momentum = 0.0;        // [N] mdot V0
  double thrust = 0.0;          // [N] mdot V0 + (pe - pa) A, if pe > pa; what a plate in free air feels
  double load = 0.0;            // [N] of the model on a plate
};
JetPush jet_push(const Scene& scene, const JetPart& part);

/// Restitution that computed flows in closed cavities of the bag's shape have.
struct RestitutionRange {
  double depth_over_width = 0.0;  // [-] along the axis, of the bag as sewn; width of a cylinder of its volume
  bool deep = false;              // deeper than wide
  double low = 0.0, high = 0.0;   // [-]
};
/// Precondition: the scene has a bag, and some of it lies ahead of the outlet.
RestitutionRange restitution_range(const Scene& scene, const jet::JetModel& model);

/// What `temperature = "static"` leaves out: gas that enters by its static enthalpy lacks V0^2 / 2.
struct MissingEnergy {
  double energy = 0.0;       // [J] up to the scene's end
  double pressure = 0.0;     // [Pa] that it would add in the bag as sewn if nothing flowed out
  double temperature = 0.0;  // [K] stagnation temperature of the same outlet, at the peak
};
/// Precondition: the scene has a bag.
MissingEnergy missing_energy(const Scene& scene, const JetPart& part);

}  // namespace driver
