// SPDX-License-Identifier: Apache-2.0
// Passenger airbag: a main panel wrapped round two side panels, with attachment, vent and strap anchors
// named.
#pragma once

#include <array>

#include "membrane/mesh.hpp"

namespace membrane {

/// Design shape of the passenger bag, the stress-free cut. Axes: x away from the support plate (depth), y
/// lateral, z up; the back lies in the plane x = 0 and is centred at y = z = 0, where the outlet is. The main
/// panel is a cylinder along y over a profile in (x, z), a rectangle with rounded corners; the side panels
/// close it at y = +-width / 2. Everything but the vent is mirror symmetric about y = 0.
struct PassengerBagOptions {
  double depth = 0.68;              // [m] x extent of the profile
  double width = 0.25;              // [m] y extent between the side panels
  double height = 0.54;             // [m] z extent of the profile
  double back_radius = 0.05;        // [m] corners of the profile at the back
  double front_radius = 0.10;       // [m] corners of the profile at the front
  int depth_cells = 22;             // cells of a side panel along x
  int width_cells = 8;              // cells of the main panel along y, even
  int height_cells = 17;            // cells of a side panel along z
  int attachment_width_cells = 6;   // even, at most width_cells
  int attachment_height_cells = 5;  // of the parity of height_cells; must lie on the flat of the back
  int vent_depth_cell = 6;          // the vent is the side panel's cells (vent_depth_cell, + 1) along x ...
  int vent_height_cell = 8;         // ... and this one along z; no node of it on the seam
};

/// Generated bag.
struct PassengerBag {
  // Elements come sorted by panel: "main", "side_left" (y < 0), "side_right" (y > 0), "attachment" (the part
  // of the back to fix, exactly in x = 0), "vent" (null panel in side_right, 4 elements whose 6 nodes are all
  // on its rim).
  Mesh mesh;
  // {back node, front node} of the straps at y = 0 above and below the outlet: the back node is on the
  // attachment's upper (lower) edge, the front node as high (low).
  std::array<std::array<int, 2>, 2> strap_anchors;
};

/// Generates the bag, 4 (ab + bc + ca) elements for a, b, c cells; 2744 by default. The default lengths give
/// 120 litres at 1 kPa overpressure, quasi-static (0.1202 m3 free, 0.1197 m3 on a rigid plate in x = 0), with
/// fabric of 60 MPa, Poisson 0.3, 0.5 mm, no compression, the attachment fixed and two straps of 620 mm and
/// 4500 N/m, which are taut then (16 and 20 N); the vent is 0.0019 m2. Throws std::invalid_argument naming
/// the option for lengths that are not positive and finite, corners that do not fit, and cell counts of the
/// wrong parity or range (at most 100).
PassengerBag passenger_bag(const PassengerBagOptions& options = {});

}  // namespace membrane
