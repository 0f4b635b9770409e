// SPDX-License-Identifier: Apache-2.0
// The search of a skin's contact with itself finds what a look at every pair finds, to the bit; nothing
// passes.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "skin_scenes.hpp"

namespace {

using scenes::Crumple;

// Both searches from the present positions on.
void expect_the_same_bits(Crumple& crumple, double thickness, int levels, int least_limited) {
  const auto model = scenes::skin_contact(crumple.skin, thickness, 1e8);
  auto searched = model.make_state(), all = model.make_state(true);
  int most = 0;
  bool edges = false;
  for (int n = 0; n < levels; ++n) {
    const auto found = scenes::level_of(model, searched, crumple.nodes);
    const auto each = scenes::level_of(model, all, crumple.nodes);
    ASSERT_EQ(found.forces, each.forces) << n;
    ASSERT_EQ(found.result.energy, each.result.energy) << n;
    ASSERT_EQ(found.result.omega_squared, each.result.omega_squared) << n;
    ASSERT_EQ(found.result.contacts, each.result.contacts) << n;
    ASSERT_EQ(found.result.approach, each.result.approach) << n;
    ASSERT_EQ(searched.limited_nodes(), all.limited_nodes()) << n;
    if (n == 0) {
      EXPECT_GE(searched.limited_nodes(), least_limited);
    }
    most = std::max(most, found.result.contacts);
    edges = edges || found.result.closest.first[1] >= 0;
    crumple.advance(found.forces, 2e-5);
  }
  EXPECT_GT(most, 20);
  EXPECT_TRUE(edges);
  EXPECT_LT(searched.looks(), all.looks() / 20);
}

TEST(SkinContactSearch, EveryPairGivesTheSameBits) {
  Crumple crumple(0.15);
  const Eigen::Matrix3Xd nothing = 0.0 * crumple.nodes;
  for (int n = 0; n < 110; ++n) crumple.advance(nothing, 2e-5);  // nothing meets yet
  expect_the_same_bits(crumple, 6e-3, 50, 0);
  // What is close now starts with limits below the thickness.
  expect_the_same_bits(crumple, 10e-3, 20, 20);
}

}  // namespace
