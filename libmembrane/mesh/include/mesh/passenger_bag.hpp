// SPDX-License-Identifier: Apache-2.0
// Passenger airbag: a main panel wrapped round two side panels, with named attachment, vent and strap
// anchors.
#pragma once

#include <array>

#include "mesh/mesh.hpp"

namespace mesh {

/// Options of passenger_bag, for the design shape: the stress-free cut. Axes: x away from the support plate
/// (depth), y lateral, z up. The back lies in x = 0 and is centred at y = z = 0, where the outlet is. The
/// main panel is a cylinder along y over a profile in (x, z), a rectangle with rounded corners. The side
/// panels close it at y = +-width / 2. Everything except the vent is mirror symmetric about y = 0.
struct PassengerBagOptions {
  double depth = 0.68;             // [m] x extent of the profile
  double width = 0.25;             // [m] y extent between the side panels
  double height = 0.54;            // [m] z extent of the profile
  double back_radius = 0.05;       // [m] corners of the profile at the back
  double front_radius = 0.10;      // [m] corners of the profile at the front
  int depth_cells = 22;            // cells of a side panel along x
  int width_cells = 8;             // cells of the main panel along y, even
  int height_cells = 17;           // cells of a side panel along z
  int attachment_width_cells = 6;  // even, at most width_cells
  /// Even if height_cells is even, else odd; the attachment must lie on the flat part of the back.
  int attachment_height_cells = 5;
  /// The vent covers the cells vent_depth_cell and vent_depth_cell + 1 of the side panel along x.
  int vent_depth_cell = 6;
  /// The vent's cell along z. No node of the vent may be on the seam.
  int vent_height_cell = 8;
};

/// Generated bag.
struct PassengerBag {
  /// Elements are sorted by panel: "main", "side_left" (y < 0), "side_right" (y > 0), "attachment", "vent".
  /// The attachment is the part of the back to fix, exactly in x = 0. The vent lies in side_right and has 4
  /// elements whose 6 nodes are all on its rim; it is meant to be a null panel.
  Mesh mesh;
  /// {back node, front node} of the straps at y = 0, above and below the outlet. The back node is on the
  /// upper (lower) edge of the attachment, the front node at the same height.
  std::array<std::array<int, 2>, 2> strap_anchors;
};

/// Generates the bag: 4 (ab + bc + ca) elements for a, b, c cells; 2744 by default.
///
/// The default lengths give 120 litres at 1 kPa overpressure, quasi-static: 0.1202 m3 free, 0.1197 m3 on a
/// rigid plate in x = 0. This holds for fabric of 60 MPa, Poisson 0.3 and 0.5 mm without compression, the
/// attachment fixed, and two straps of 620 mm and 4500 N/m. The straps are then taut (16 and 20 N). The vent
/// is 0.0019 m2.
///
/// Throws std::invalid_argument, naming the option, for
/// - lengths that are not positive and finite,
/// - corners that do not fit,
/// - cell counts of the wrong parity or range (at most 100).
PassengerBag passenger_bag(const PassengerBagOptions& options = {});

}  // namespace mesh
