// SPDX-License-Identifier: Apache-2.0
// One direction of the warp for elements that each have their own.
#pragma once

#include "import/bag_deck.hpp"
#include "import/import_report.hpp"

namespace driver::imported {

struct WarpDirection {
  Eigen::Vector3d along;
  double spread_degrees;  // root mean square of the angle between it, in an element's plane, and the
                          // element's own
};

/// The direction that is nearest to the first sides of a panel's elements, turned by `beta` degrees in their
/// planes. Weighted by area, in the stress-free shape.
WarpDirection mean_direction(const BagDeck& bag, const std::string& panel, double beta);

/// A stress curve as cases allow it: from (0, 0), rising, of at most 64 points. Says what it changed.
Knots as_stress_curve(const Knots& knots, ImportReport& report);

}  // namespace driver::imported
