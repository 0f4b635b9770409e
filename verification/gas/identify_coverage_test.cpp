// SPDX-License-Identifier: Apache-2.0
#include "tank_test_cases.hpp"

// The bands over many noisy tank tests: 1 % of the reading on tank and chamber, 10 kHz over 60 ms.
namespace {

using namespace cases;

Coverage measured(const char* name, const Truth& truth, double mean_temperature, int seeds) {
  const Coverage c =
      coverage(one_gas_test(), truth, mean_temperature, 0.01, 1000, seeds, {.points = 101, .draws = 200});
  std::printf(
      "%s: inside mass flow %.4f, temperature %.4f, mean T %.3f, Cd A %.3f; deviation of ln T %.4f, actual "
      "%.4f\n",
      name, c.mass_flow, c.temperature, c.mean_temperature, c.effective_area, c.width, c.error);
  return c;
}

/// The true curves lie inside the pointwise 95 % bands at 90 % or more of the points above the default
/// threshold of |K| (5 % of its largest), and the bands are no wider than the errors call for.
TEST(identify_coverage, two_hundred_noisy_records) {
  const Coverage c = measured("smooth pulse", one_gas_truth(1e-4), 600.0, 200);
  EXPECT_GE(c.mass_flow, 0.90);
  EXPECT_GE(c.temperature, 0.90);
  EXPECT_GT(c.error, 0.6 * c.width);
  // One value a record, 95 % by construction: 200 or 100 records leave a standard error of 0.02.
  EXPECT_GE(c.mean_temperature, 0.87);
  EXPECT_GE(c.effective_area, 0.87);
}

/// A flow with corners, which smoothing rounds: the posterior holds this bias on average over the record.
TEST(identify_coverage, flow_with_corners) {
  const Coverage c = measured("triangle", triangle_truth, 700.0, 100);
  EXPECT_GE(c.mass_flow, 0.90);
  EXPECT_GE(c.temperature, 0.90);
  EXPECT_GT(c.error, 0.6 * c.width);
  // One value a record, 95 % by construction: 200 or 100 records leave a standard error of 0.02.
  EXPECT_GE(c.mean_temperature, 0.87);
  EXPECT_GE(c.effective_area, 0.87);
}

}  // namespace
