// SPDX-License-Identifier: Apache-2.0
// Levels that need no evaluation: the answer is certain, and the results are those of evaluating every level.
#include <gtest/gtest.h>

#include "coupling/side.hpp"
#include "scenes.hpp"

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

using scenes::kRadius;
using scenes::kStiffness;

struct Counts {
  int touching = 0, skipped = 0, needless = 0;
};

// A sphere wanders over a plate that waves; `share` of the true motion is told.
Counts wander(double size, double share, int seed) {
  const scenes::Skin flat = scenes::plate(static_cast<int>(12.0 / size), size * kRadius);
  const auto model = scenes::contact(flat, kRadius, kStiffness);
  auto state = model.make_state();
  Matrix3Xd last = flat.nodes, forces = Matrix3Xd::Zero(3, last.cols());
  Vector3d last_centre = Vector3d::Zero();
  Counts counts;
  for (int n = 0; n < 1500; ++n) {
    const double s = 0.01 * n + seed;
    Matrix3Xd nodes = flat.nodes;
    for (Eigen::Index a = 0; a < nodes.cols(); ++a)
      nodes(2, a) = 0.2 * kRadius * std::sin(3.0 * s + 20.0 * nodes(0, a));
    const Vector3d centre(0.1 * std::sin(s), 0.1 * std::cos(0.7 * s),
                          kRadius * (3.5 + 2.7 * std::sin(2.1 * s)));
    const double motion =
        std::sqrt((nodes - last).colwise().squaredNorm().maxCoeff()) + (centre - last_centre).norm();
    last = nodes;
    last_centre = centre;
    const bool touches = scenes::touch(model, nodes, centre).result.deepest_element >= 0;
    counts.touching += touches;
    if (model.stays_clear(state, share * motion)) {
      ++counts.skipped;
      EXPECT_TRUE(!touches || share < 1.0) << n;
      continue;
    }
    const auto far = coupling::smallest_gap(flat.triangles, nodes, centre, kRadius).distance;
    counts.needless += far > kRadius;
    const auto result = model.evaluate(state, nodes, centre, forces.setZero());
    const auto fresh = scenes::touch(model, nodes, centre);
    EXPECT_EQ(result.energy, fresh.result.energy) << n;
    EXPECT_EQ(forces, fresh.forces) << n;
  }
  return counts;
}

TEST(ContactIdle, skipped_levels_touch_nothing_and_the_rest_keep_their_bits) {
  for (const double size : {0.3, 1.0, 3.0})
    for (const int seed : {1, 2, 3}) {
      const Counts c = wander(size, 1.0, seed);
      EXPECT_GT(c.touching, 50) << size;
      EXPECT_GT(c.skipped, 800) << size;
      EXPECT_LT(c.needless, 60) << size;  // farther than r: one look in a dozen levels or fewer
    }
}

TEST(ContactIdle, first_level_and_motion_that_is_no_number_are_never_clear) {
  const scenes::Skin skin = scenes::plate(4, kRadius);
  const auto model = scenes::contact(skin, kRadius, kStiffness);
  auto state = model.make_state();
  EXPECT_FALSE(model.stays_clear(state, 0.0));
  Matrix3Xd forces = Matrix3Xd::Zero(3, skin.nodes.cols());
  model.evaluate(state, skin.nodes, {0.0, 0.0, 10.0 * kRadius}, forces);
  EXPECT_TRUE(model.stays_clear(state, 0.0));
  EXPECT_FALSE(model.stays_clear(state, std::nan("")));
  EXPECT_FALSE(model.stays_clear(state, 9.0 * kRadius));  // the gap
  EXPECT_TRUE(model.stays_clear(state, 8.0 * kRadius));   // certain from bounding circles, one element short
  EXPECT_FALSE(model.stays_clear(state, kRadius));        // what is left of it
}

// The path over skipped levels is covered too: a centre that jumps across after them is found.
TEST(ContactIdle, jump_after_skipped_levels_is_found) {
  const scenes::Skin skin = scenes::plate(6, kRadius);
  const auto model = scenes::contact(skin, kRadius, kStiffness);
  auto state = model.make_state();
  Matrix3Xd forces = Matrix3Xd::Zero(3, skin.nodes.cols());
  model.evaluate(state, skin.nodes, {0.001, 0.002, 5.0 * kRadius}, forces);
  EXPECT_TRUE(model.stays_clear(state, kRadius));
  EXPECT_FALSE(model.stays_clear(state, 8.0 * kRadius));
  EXPECT_THROW(model.evaluate(state, skin.nodes, {0.003, 0.001, -4.0 * kRadius}, forces),
               coupling::ContactError);
}

}  // namespace
