// SPDX-License-Identifier: Apache-2.0
// The ladder of the paper's scene over the jet: chaotic, so by means, and the jet cannot be left out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "many_runs/ladder.hpp"

namespace {

TEST(ladder_long, papers_impactor_needs_the_jet) {
  driver::LadderOptions options;
  options.quantity = "pendulum_angle";
  options.tolerance = 0.1;
  options.hold = {"mesh", "pieces", "step", "gas", "cp", "porosity", "compression", "outlet"};
  options.quiet = true;
  const auto result = driver::run_ladder(GASJET_SOURCE_DIR "/cases/passenger_pendulum.toml", {}, options, 2);
  EXPECT_TRUE(result.chaotic);
  for (const auto& rung : result.rungs) {
    EXPECT_EQ(rung.value.count, 16) << rung.name;
    EXPECT_GT(rung.value.standard_error, 0.0) << rung.name;
  }
  const auto off = std::find_if(result.rungs.begin(), result.rungs.end(),
                                [](const auto& rung) { return rung.name == "jet off"; });
  ASSERT_NE(off, result.rungs.end());
  EXPECT_EQ(off->verdict, driver::Verdict::outside);
  EXPECT_LT(off->error, -5.0 * off->standard_error);
  ASSERT_TRUE(result.cheapest.has_value());
  EXPECT_NE(result.rungs[*result.cheapest].name, "jet off");
}

}  // namespace
