// SPDX-License-Identifier: Apache-2.0
#include "tank_test_cases.hpp"

// 200 noisy tank tests.
namespace {

/// 1 % of the reading on tank and chamber, 10 kHz over 60 ms: the true curves lie inside the pointwise 95 %
/// bands at 90 % or more of the points
/// above the default threshold of |K| (5 % of its largest).
TEST(identify_coverage, two_hundred_noisy_records) {
  const cases::Coverage c = cases::coverage(0.01, 1000, 200, {.points = 101, .draws = 200});
  std::printf(
      "inside: mass flow %.4f, temperature %.4f; mean T %.3f, Cd A %.3f; deviation of ln T by band %.4f, "
      "actual %.4f\n",
      c.mass_flow, c.temperature, c.mean_temperature, c.effective_area, c.width, c.error);
  EXPECT_GE(c.mass_flow, 0.90);
  EXPECT_GE(c.temperature, 0.90);
  EXPECT_GT(c.error, 0.6 * c.width);
}

}  // namespace
