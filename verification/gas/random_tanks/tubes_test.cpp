// SPDX-License-Identifier: Apache-2.0
// Proved bounds of the random tanks, as they ship.
#include <gtest/gtest.h>

#include "comparison.hpp"
#include "tube.hpp"

namespace {

using namespace random_tanks;

TEST(random_tubes, hold_libgas) {
  const auto shipped = read_shipped(GASJET_TUBES);
  EXPECT_GE(shipped.size(), 120U);
  int compared = 0;
  for (const auto& [seed, tube] : shipped) {
    const Tank tank = random_tank(seed);
    const Computed run = libgas_route(tank);
    if (!run.refusal.empty()) continue;  // judged in two_routes_test.cpp
    ++compared;
    EXPECT_LE(distance(run, tube.bounds), kAllowedTolerances * tank.tolerance) << "seed " << seed;
  }
  EXPECT_GE(compared, 120);
}

// Of the tanks that take few steps.
TEST(random_tubes, computed_anew_meet_shipped_ones) {
  int computed = 0;
  for (const auto& [seed, shipped] : read_shipped(GASJET_TUBES)) {
    if (shipped.steps > 100 || computed == 30) continue;
    ++computed;
    const Tank tank = random_tank(seed);
    const ShippedTube anew = compute_shipped(tank, scene_of(tank, GASJET_NASA7).value(), 60.0);
    ASSERT_EQ(anew.bounds.size(), shipped.bounds.size());
    for (std::size_t row = 0; row < anew.bounds.size(); ++row)
      for (std::size_t i = 0; i < 3; ++i) {
        const Proved &a = anew.bounds[row], &b = shipped.bounds[row];
        EXPECT_LE(std::max(a.lower[i], b.lower[i]), std::min(a.upper[i], b.upper[i])) << "seed " << seed;
        EXPECT_LE(a.upper[i] - a.lower[i], kShippedWidth * a.upper[i]) << "seed " << seed;
      }
  }
  EXPECT_EQ(computed, 30);
}

}  // namespace
