// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <map>

#include "comparison.hpp"
#include "tight_tanks.hpp"
#include "tube.hpp"

// libgas against proved bounds.
namespace {

using namespace random_tanks;

const char* const kSpecies = GASJET_NASA7;

TEST(tubes, hold_libgas_on_random_tanks) {
  std::map<std::string, int> refusals;
  int enclosed = 0, other = 0, refused_by_libgas = 0;
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Tank tank = random_tank(seed);
    const auto scene = scene_of(tank, kSpecies);
    if (!scene) {
      ++other;
      continue;
    }
    try {
      const double distance = distance_to_tube(tank, *scene, 1e-10, 1.0);
      if (std::isnan(distance)) {
        ++refused_by_libgas;
        continue;
      }
      ++enclosed;
      worst = std::max(worst, distance / tank.tolerance);
      EXPECT_LE(distance, kAllowedTolerances * tank.tolerance) << "seed " << seed;
    } catch (const enclosure::Refusal& refusal) {
      std::cout << "seed " << seed << ": " << refusal.what() << '\n';
      ++refusals[std::string(refusal.what()).substr(0, 20)];
    }
  }
  std::cout << enclosed << " enclosed, at most " << worst << " tolerances off; " << other
            << " of other kinds; " << refused_by_libgas << " refused by libgas\n";
  for (const auto& [reason, count] : refusals) std::cout << count << " refused: " << reason << "...\n";
  EXPECT_GE(enclosed, 60);
}

// The error of a run with sub-steps of 1e-13; changes_test.py has libgas wrong by 1e-11 in one place each.
TEST(tubes, hold_tightest_runs) {
  int number = 0;
  for (const Tank& tank : tight_tanks()) {
    const double distance = distance_to_tube(tank, scene_of(tank, kSpecies).value(), 1e-13, 60.0);
    std::cout << "tank " << ++number << ": off by " << distance << '\n';
    EXPECT_LE(distance, 1e-12) << number;
  }
}

}  // namespace
