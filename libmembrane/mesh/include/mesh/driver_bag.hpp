// SPDX-License-Identifier: Apache-2.0
// Driver airbag: two flat discs sewn together at the rim, with named inflator hole, vents and tether anchors.
#pragma once

#include <array>

#include "mesh/mesh.hpp"

namespace mesh {

/// Options of driver_bag. Axes: x away from the steering wheel, z up; the outlet is at the origin. The discs
/// are cut from plane fabric.
struct DriverBagOptions {
  double radius = 0.35;           // [m] radius of the flat discs
  double inflator_radius = 0.05;  // [m] radius of the attachment, below `radius`
  /// [m] distance between the middles of the discs in the initial shape; below radius - inflator_radius.
  double opening = 0.04;
  int rings = 14;          // rings of each disc, at most 100
  int inflator_rings = 2;  // rings of the attachment, 1 to rings - 3
  int vents = 2;           // 0, 1 or 2, beside each other on the back
  /// The vents lie between this ring and the next one; above inflator_rings, below rings - 1.
  int vent_ring = 7;
};

/// Generated bag.
struct DriverBag {
  /// The flat discs, both in x = 0: the stress-free design shape, which encloses no volume. 12 rings^2
  /// elements, sorted by panel: "front", "back", "attachment", "vent_left" (y < 0), "vent_right". The
  /// attachment is the part of the back within inflator_radius, which the module holds. A vent has 4 elements
  /// whose 6 nodes are all on its rim; it is meant to be a null panel. A vent that is not generated has no
  /// panel.
  Mesh mesh;
  /// Initial shape, 3 x nodes [m]. Both discs become shallow cones, mirror images about their rim. They keep
  /// the lengths of the meridians and shorten the hoops. The attachment stays in x = 0. Nothing is stretched,
  /// and nothing intersects.
  Eigen::Matrix3Xd opened;
  /// {back node, front node} of three tethers. Each runs from the attachment's rim to the opposite node of
  /// the front. They are 120 degrees apart, the first one above the outlet.
  std::array<std::array<int, 2>, 3> tether_anchors;
};

/// Generates the bag. Throws std::invalid_argument that names an option out of its range.
DriverBag driver_bag(const DriverBagOptions& options = {});

}  // namespace mesh
