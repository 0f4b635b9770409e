// SPDX-License-Identifier: Apache-2.0
// Random scenes, and a second route for them without balls: (G.8) to (G.11) in masses and internal energy, in
// numbers of 64 bits, by extrapolation.
#pragma once

#include "known.hpp"

namespace test {

using Real = long double;

/// Columns as those of the tube, at `time` [s]; empty if the scene is too stiff. Each step is good to
/// `tolerance`.
std::vector<Real> solve(const enclosure::Scene& scene, double time, Real tolerance);

/// A scene with its end [s].
struct RandomScene {
  enclosure::Scene scene;
  double end;
};
RandomScene random_scene(unsigned seed);

/// Of scenes of seeds first to last: how many solutions were compared, and how many tubes were refused.
struct Tally {
  int compared = 0, refused = 0, stiff = 0;
};
/// Expects each solution in its tube.
Tally expect_tubes_contain(unsigned first, unsigned last);

}  // namespace test
