// SPDX-License-Identifier: Apache-2.0
// How much a jet pushes, and how far its model may be off (docs/theory/jet_push.md).
#pragma once

#include <optional>

#include "engine/scene.hpp"

namespace driver {

/// A jet at its inflator's greatest mass flow, with pressure_around() in the bag.
struct JetPush {
  double pressure_ratio = 0.0;    // [-] pe / p of a sonic outlet
  double momentum = 0.0;          // [N] mdot V0
  double thrust = 0.0;            // [N] of an expanded outlet: what a plate in free air feels
  double rest_temperature = 0.0;  // [K] stagnation temperature of the same outlet
  double load = 0.0;              // [N] of the model on a plate; of a curve of restitution the least
  double most_load = 0.0;         // [N] and the most
};
JetPush jet_push(const Scene& scene, const JetPart& part);

/// Least and most restitution of a jet [-]: of the curve, if it has one.
struct Range {
  double low = 0.0, high = 0.0;
};
Range restitution(const JetPart& part);

/// Restitution that computed flows in closed cavities of the bag's shape have.
struct RestitutionRange {
  /// [-] Of the bag as sewn: its depth ahead of the outlet over the diameter of its projection.
  double depth_over_width = 0.0;
  bool deep = false;             // deeper than wide
  double low = 0.0, high = 0.0;  // [-]
};
/// Nothing without a bag, and for one that is flat as sewn or has nothing ahead of the outlet.
std::optional<RestitutionRange> restitution_range(const Scene& scene, const jet::JetModel& model);

/// What `temperature = "static"` leaves out: gas that enters by its static enthalpy lacks V0^2 / 2.
struct MissingEnergy {
  double energy = 0.0;  // [J] up to the scene's end
  /// [Pa] What it would add in the bag as sewn if nothing flowed out; none of a bag that is flat as sewn.
  std::optional<double> pressure{};
};
MissingEnergy missing_energy(const Scene& scene, const JetPart& part);

}  // namespace driver
