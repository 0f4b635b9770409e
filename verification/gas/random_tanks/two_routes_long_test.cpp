// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <iostream>
#include <set>

#include "claim.hpp"
#include "comparison.hpp"

namespace {

using namespace random_tanks;

constexpr int kTanks = 10000;

// Tanks where libgas is further off than 100 tolerances. 5138, at 1e-10: flow sets in at p_a in a volume that
// follows the pressure, and the first sub-step is longer than the laminar range. 7086, 1e-10: that range is
// felt where the gas rests at p_a. 3833, 1e-10: the gas passes 1000 K, where cp jumps. 3489: 155 tolerances
// of 1e-8.
const std::set<std::uint64_t> kKnown{3489, 3833, 5138, 7086};

TEST(two_routes, agree_on_ten_thousand_random_tanks) {
  const Tally tally = compare_seeds(1, kTanks, GASJET_NASA7);
  for (std::size_t i = 0; i < kVerdicts; ++i)
    std::cout << name_of(static_cast<Verdict>(i)) << ' ' << tally.counts[i] << '\n';
  claim::expect_near(
      {"G.9", "10,000 random tanks: largest residual of mass or energy [-]", "some thousand roundings"},
      tally.worst_balance, 0.0, 1e-12);
  for (const std::uint64_t seed : tally.disagreeing) EXPECT_TRUE(kKnown.contains(seed)) << "seed " << seed;
  EXPECT_LE(tally.count(Verdict::undecided) + tally.count(Verdict::sensitive), 0.02 * kTanks);
  EXPECT_LE(tally.count(Verdict::too_stiff), 0.001 * kTanks);
  EXPECT_GE(tally.count(Verdict::refused_rightly), 0.005 * kTanks);
}

}  // namespace
