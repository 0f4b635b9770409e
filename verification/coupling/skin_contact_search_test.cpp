// SPDX-License-Identifier: Apache-2.0
// The search of a skin's contact with itself finds what a look at every pair finds, to the bit; nothing
// passes.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "skin_scenes.hpp"

namespace {

using scenes::Crumple;

TEST(SkinContactSearch, EveryPairGivesTheSameBits) {
  Crumple crumple(0.15);
  const auto model = scenes::skin_contact(crumple.skin, 6e-3, 1e8);
  auto searched = model.make_state(), all = model.make_state(true);
  int most = 0;
  bool edges = false;
  for (int n = 0; n < 150; ++n) {
    const auto found = scenes::level_of(model, searched, crumple.nodes);
    const auto each = scenes::level_of(model, all, crumple.nodes);
    ASSERT_EQ(found.forces, each.forces) << n;
    ASSERT_EQ(found.result.energy, each.result.energy) << n;
    ASSERT_EQ(found.result.omega_squared, each.result.omega_squared) << n;
    ASSERT_EQ(found.result.contacts, each.result.contacts) << n;
    ASSERT_EQ(found.result.approach, each.result.approach) << n;
    ASSERT_EQ(searched.limited_nodes(), all.limited_nodes()) << n;
    most = std::max(most, found.result.contacts);
    edges = edges || found.result.closest.first[1] >= 0;
    crumple.advance(found.forces, 2e-5);
  }
  EXPECT_GT(most, 20);
  EXPECT_TRUE(edges);
  EXPECT_LT(searched.looks(), all.looks() / 20);
}

}  // namespace
