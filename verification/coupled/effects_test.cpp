// SPDX-License-Identifier: Apache-2.0
// When the difference of two ensembles' means is decided: Welch's test, by its closed forms for few runs.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "many_runs/ensemble.hpp"

namespace {

/// Runs of one case: `count` of them, alternately above and below the mean by `scatter`.
std::vector<double> runs(int count, double mean, double scatter) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(mean + (i % 2 == 0 ? scatter : -scatter));
  return values;
}

driver::Effect effect(const std::vector<double>& with, const std::vector<double>& without) {
  driver::EnsembleResult a, b;
  a.quantities["q"] = with;
  b.quantities["q"] = without;
  return driver::effects(a, b).at(0);
}

/// Chance that 16 runs differ by more than 5 of their standard errors from a mean that is theirs: Student's
/// integral with 15 degrees of freedom, by the midpoint rule in the angle, t = sqrt(15) tan u.
double chance() {
  const double freedom = 15.0;
  const double from = std::atan(5.0 / std::sqrt(freedom)), to = 0.5 * std::numbers::pi;
  const double scale =
      std::tgamma(0.5 * (freedom + 1.0)) / std::tgamma(0.5 * freedom) / std::sqrt(std::numbers::pi);
  double sum = 0.0;
  const int points = 10000;
  for (int i = 0; i < points; ++i)
    sum += std::pow(std::cos(from + (i + 0.5) * (to - from) / points), freedom - 1.0);
  return scale * sum * (to - from) / points;
}

TEST(effect, thousands_of_standard_errors_decide_with_eight_runs) {
  const auto e = effect(runs(8, 1.0, 1e-3), runs(8, 2.0, 1e-3));
  EXPECT_GT(e.standard_errors, 1000.0);
  EXPECT_TRUE(e.decided());
}

TEST(effect, needed_eq_students_quantile_in_closed_form) {
  const double p = chance(), u = 1.0 - 2.0 * p;
  // One degree of freedom is Cauchy's distribution; two have a root. Tolerance: the midpoint rule's.
  EXPECT_NEAR(effect(runs(2, 1.0, 1.0), runs(100, 1.0, 0.0)).needed * std::tan(std::numbers::pi * p), 1.0,
              1e-6);
  EXPECT_NEAR(effect(runs(3, 1.0, 1.0), runs(100, 1.0, 0.0)).needed / (u * std::sqrt(2.0 / (1.0 - u * u))),
              1.0, 1e-6);
  // Equal scatter on both sides: one degree each is two.
  EXPECT_NEAR(effect(runs(2, 1.0, 1.0), runs(2, 5.0, 1.0)).needed / (u * std::sqrt(2.0 / (1.0 - u * u))), 1.0,
              1e-6);
}

TEST(effect, needed_is_five_from_sixteen_runs_on) {
  EXPECT_NEAR(effect(runs(16, 1.0, 1.0), runs(16, 1.0, 0.0)).needed, 5.0, 1e-9);
  EXPECT_EQ(effect(runs(16, 1.0, 1.0), runs(16, 1.0, 1.0)).needed, 5.0);
  EXPECT_EQ(effect(runs(500, 1.0, 1.0), runs(64, 1.0, 0.1)).needed, 5.0);
  double before = HUGE_VAL;
  for (int count = 2; count <= 16; ++count) {
    const double needed = effect(runs(count, 1.0, 1.0), runs(count, 1.0, 0.0)).needed;
    EXPECT_LE(needed, before) << count;
    before = needed;
  }
}

TEST(effect, one_run_decides_nothing_and_runs_without_scatter_all) {
  EXPECT_FALSE(effect(runs(1, 1.0, 0.0), runs(500, 2.0, 1e-9)).decided());
  EXPECT_TRUE(effect(runs(2, 1.0, 0.0), runs(2, 1.0 + 1e-12, 0.0)).decided());
  EXPECT_FALSE(effect(runs(2, 1.0, 0.0), runs(2, 1.0, 0.0)).decided());
}

}  // namespace
