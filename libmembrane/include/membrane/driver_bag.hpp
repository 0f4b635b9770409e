// SPDX-License-Identifier: Apache-2.0
// Driver airbag: two flat discs sewn together at the rim, with inflator hole, vents and tether anchors named.
#pragma once

#include <array>

#include "membrane/mesh.hpp"

namespace membrane {

/// Axes: x away from the steering wheel, z up; the discs are cut from plane fabric, the outlet is at the
/// origin.
struct DriverBagOptions {
  double radius = 0.35;           // [m] of the discs, flat
  double inflator_radius = 0.05;  // [m] of the attachment, below radius
  double opening =
      0.04;        // [m] between the discs' middles in the initial shape, below radius - inflator_radius
  int rings = 14;  // of each disc, at most 100
  int inflator_rings = 2;  // rings of the attachment, 1 to rings - 3
  int vents = 2;           // 0, 1 or 2, beside each other on the back
  int vent_ring = 7;       // vents lie between this ring and the next; above inflator_rings, below rings - 1
};

/// Generated bag.
struct DriverBag {
  // The flat discs, both in x = 0: the stress-free design shape, which encloses nothing. 12 rings^2 elements,
  // sorted by panel: "front", "back", "attachment" (the back within inflator_radius: what the module holds),
  // "vent_left" (y < 0), "vent_right": 4 elements each whose 6 nodes are all on the rim, to be null panels.
  // No panel "vent_..." without it.
  Mesh mesh;
  // Initial shape, 3 x nodes: both discs become shallow cones, mirror images about their rim, that keep the
  // meridians' lengths and shorten the hoops; the attachment stays in x = 0. Nothing is stretched, nothing
  // intersects.
  Eigen::Matrix3Xd opened;
  // {back node, front node} of three tethers, from the attachment's rim to the same place of the front, 120
  // degrees apart, the first above the outlet.
  std::array<std::array<int, 2>, 3> tether_anchors;
};

/// Generates the bag. Throws std::invalid_argument naming the option out of the ranges above.
DriverBag driver_bag(const DriverBagOptions& options = {});

}  // namespace membrane
