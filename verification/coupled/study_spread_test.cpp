// SPDX-License-Identifier: Apache-2.0
// Random inputs and the spread of results against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "many_runs/distribution.hpp"
#include "many_runs/spread.hpp"

namespace {

using driver::Correlation;
using driver::LogNormalDistribution;
using driver::NormalDistribution;
using driver::TriangularDistribution;

constexpr double infinite = std::numeric_limits<double>::infinity();

double normal_share(double z) {
  return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

const std::vector<double> shares{1e-6, 0.01, 0.2, 0.5, 0.7, 0.99, 1.0 - 1e-6};

// A quantile's error of eps moves the share by eps times x f(x), of order one.
TEST(study_spread, shares_below_quantiles_are_the_ones_asked_for) {
  const NormalDistribution normal{3.0, 0.5, -infinite, infinite}, cut{3.0, 0.5, 2.9, 3.7};
  const LogNormalDistribution log_normal{2.0, 1.3};
  const TriangularDistribution triangular{-1.0, 0.5, 4.0};
  const double low = normal_share(-0.2), high = normal_share(1.4);
  for (const double share : shares) {
    EXPECT_NEAR(normal_share((driver::quantile(normal, share) - 3.0) / 0.5), share, 1e-14);
    EXPECT_NEAR((normal_share((driver::quantile(cut, share) - 3.0) / 0.5) - low) / (high - low), share,
                1e-14);
    EXPECT_NEAR(normal_share(std::log(driver::quantile(log_normal, share) / 2.0) / std::log(1.3)), share,
                1e-14);
    const double x = driver::quantile(triangular, share);
    const double below =
        x < 0.5 ? (x + 1.0) * (x + 1.0) / (5.0 * 1.5) : 1.0 - (4.0 - x) * (4.0 - x) / (5.0 * 3.5);
    EXPECT_NEAR(below, share, 1e-14);
  }
  EXPECT_NEAR(driver::share_inside(cut), high - low, 1e-15);
}

// Beyond four deviations the share above is 1 to five digits only, but its tail keeps them all.
TEST(study_spread, far_tails_keep_their_digits) {
  const NormalDistribution above{0.0, 1.0, 6.0, infinite}, below{0.0, 1.0, -infinite, -6.0};
  const double tail = 0.5 * std::erfc(6.0 / std::numbers::sqrt2);
  EXPECT_NEAR(driver::share_inside(above) / tail, 1.0, 1e-13);
  for (const double share : shares) {
    const double x = driver::quantile(above, share);
    EXPECT_NEAR(0.5 * std::erfc(x / std::numbers::sqrt2) / tail, 1.0 - share, 1e-12) << share;
    EXPECT_NEAR(driver::quantile(below, 1.0 - share), -x, 1e-10 * x) << share;  // 1 - share is rounded
  }
  EXPECT_GE(driver::quantile(above, 0.0), 6.0);
  EXPECT_TRUE(std::isfinite(driver::quantile(above, 1.0)));
  const TriangularDistribution to_the_right{0.0, 2.0, 2.0};
  EXPECT_NEAR(driver::quantile(to_the_right, 0.25), 1.0, 1e-15);
}

double correlation(const std::vector<driver::UnitPoint>& points, std::size_t first, std::size_t second,
                   double (*of)(double)) {
  double aa = 0.0, bb = 0.0, ab = 0.0, mean_a = 0.0, mean_b = 0.0;
  const double n = static_cast<double>(points.size());
  for (const auto& p : points) mean_a += of(p[first]) / n, mean_b += of(p[second]) / n;
  for (const auto& p : points) {
    const double x = of(p[first]) - mean_a, y = of(p[second]) - mean_b;
    aa += x * x, bb += y * y, ab += x * y;
  }
  return ab / std::sqrt(aa * bb);
}

double score(double unit) {
  return driver::quantile(NormalDistribution{0.0, 1.0, -infinite, infinite}, unit);
}
double same(double unit) {
  return unit;
}

TEST(study_spread, a_copula_has_its_coefficients_and_keeps_its_margins) {
  Correlation all(3);
  all.set(0, 1, 0.8), all.set(1, 2, -0.3), all.set(0, 2, driver::coefficient_from_ranks(0.2));
  ASSERT_TRUE(all.factorise());
  double before = 1.0;
  for (const int count : {255, 4095}) {
    auto points = driver::sobol_sequence(count, 3);
    const auto first = points;
    for (auto& p : points) all.apply(p);
    const double worst = std::max({std::abs(correlation(points, 0, 1, score) - 0.8),
                                   std::abs(correlation(points, 1, 2, score) + 0.3),
                                   std::abs(correlation(points, 0, 2, same) - 0.2)});
    EXPECT_LT(worst, 2.0 / std::sqrt(count));  // two standard errors of independent samples
    EXPECT_LT(worst, before / 2.0);            // 16 times the points: a quarter at the order -1/2
    before = worst;
    for (std::size_t f = 0; f < 3; ++f) {
      std::vector<double> margin;
      for (std::size_t i = 0; i < points.size(); ++i) {
        margin.push_back(points[i][f]);
        if (f == 0) {
          EXPECT_EQ(points[i][0], first[i][0]);
        }
      }
      std::ranges::sort(margin);
      for (std::size_t i = 0; i < margin.size(); ++i)  // Kolmogorov's distance at 1 %
        EXPECT_NEAR(margin[i], (static_cast<double>(i) + 0.5) / count, 1.63 / std::sqrt(count));
    }
  }
  // Of three, two near 1 and one near -1 are impossible.
  Correlation none(3);
  none.set(0, 1, 0.9), none.set(1, 2, 0.9), none.set(0, 2, -0.9);
  EXPECT_FALSE(none.factorise());
  // Ranks of normal numbers: Pearson's relation, and its ends.
  EXPECT_NEAR(driver::coefficient_from_ranks(1.0), 1.0, 1e-15);
  EXPECT_NEAR(6.0 / std::numbers::pi * std::asin(driver::coefficient_from_ranks(0.4) / 2.0), 0.4, 1e-15);
}

std::vector<std::vector<double>> numbers_to(int n) {
  std::vector<std::vector<double>> list;
  for (int i = 1; i <= n; ++i) list.push_back({static_cast<double>(i)});
  return list;
}

// Ranks of the order statistics that bound a median: tables of the sign test, 6 and 15 of 20 values.
TEST(study_spread, intervals_of_percentiles_have_the_ranks_of_the_tables) {
  const auto of_20 = driver::spread(numbers_to(20));
  ASSERT_TRUE(of_20);
  EXPECT_EQ(of_20->percentiles[2].value, 10.5);
  EXPECT_EQ(of_20->percentiles[2].low, 6.0);
  EXPECT_EQ(of_20->percentiles[2].high, 15.0);
  EXPECT_FALSE(of_20->percentiles.front().low);
  EXPECT_FALSE(of_20->percentiles.back().high);
  // 0.95^n falls below 0.025.
  const int fewest = static_cast<int>(driver::fewest_for_outer);
  EXPECT_EQ(fewest, static_cast<int>(std::ceil(std::log(0.025) / std::log(0.95))));
  EXPECT_FALSE(driver::spread(numbers_to(fewest - 1))->percentiles.front().low);
  EXPECT_EQ(driver::spread(numbers_to(fewest))->percentiles.front().low, 1.0);
  EXPECT_EQ(driver::spread(numbers_to(fewest))->percentiles.back().high, fewest);
  EXPECT_FALSE(driver::spread({{1.0}, {}}));
}

// Runs of a point that are all alike tell no more than one of them.
TEST(study_spread, runs_of_one_point_do_not_narrow_an_interval) {
  auto twice = numbers_to(100);
  for (auto& runs : twice) runs.push_back(runs.front());
  const auto one = driver::spread(numbers_to(100)), two = driver::spread(twice);
  ASSERT_TRUE(one && two);
  EXPECT_EQ(two->points, 100);
  EXPECT_EQ(two->runs, 200);
  EXPECT_EQ(one->standard_error, two->standard_error);
  EXPECT_EQ(one->percentiles[1].low, two->percentiles[1].low);
  EXPECT_EQ(one->percentiles[3].high, two->percentiles[3].high);
}

TEST(study_spread, chances_have_the_intervals_of_clopper_and_pearson) {
  const auto none = driver::chance(0.0, 50), all = driver::chance(1.0, 50);
  EXPECT_EQ(none.low, 0.0);
  EXPECT_NEAR(none.high, 1.0 - std::pow(0.025, 1.0 / 50.0), 1e-14);  // closed form
  EXPECT_NEAR(all.low, std::pow(0.025, 1.0 / 50.0), 1e-14);
  EXPECT_EQ(all.high, 1.0);
  // At an end of the interval the count seen, or one beyond it, has a chance of 2.5 %.
  const auto some = driver::chance(0.1, 100);
  const auto tail = [](double p, int from, int to) {
    double sum = 0.0;
    for (int k = from; k <= to; ++k)
      sum += std::exp(std::lgamma(101.0) - std::lgamma(k + 1.0) - std::lgamma(101.0 - k) + k * std::log(p) +
                      (100 - k) * std::log1p(-p));
    return sum;
  };
  EXPECT_NEAR(tail(some.low, 10, 100), 0.025, 1e-12);
  EXPECT_NEAR(tail(some.high, 0, 10), 0.025, 1e-12);
  // A million points, where half a per cent is known to 3 %.
  const auto many = driver::chance(0.005, 1'000'000);
  EXPECT_NEAR(many.high - many.low, 2.0 * 1.96 * std::sqrt(0.005 * 0.995 / 1e6), 2e-6);
}

// 2000 samples of independent numbers with a long tail: each interval has the truth in 95 % or more of them,
// less four standard errors of 2000 trials.
TEST(study_spread, intervals_hold_the_truth_in_95_percent_of_samples) {
  constexpr int trials = 2000, count = 100;
  std::mt19937_64 generator(7);
  std::exponential_distribution<double> exponential;
  std::vector<int> held(7, 0);
  for (int t = 0; t < trials; ++t) {
    std::vector<std::vector<double>> values;
    for (int i = 0; i < count; ++i) values.push_back({exponential(generator)});
    const auto s = driver::spread(values);
    const auto beyond = std::ranges::count_if(values, [](const auto& v) { return v.front() > 2.0; });
    const auto chance = driver::chance(static_cast<double>(beyond) / count, count);
    for (std::size_t k = 0; k < 5; ++k) {
      const double truth = -std::log1p(-s->percentiles[k].percent / 100.0);
      held[k] +=
          s->percentiles[k].low.value_or(0.0) <= truth && truth <= s->percentiles[k].high.value_or(1e9);
    }
    held[5] += chance.low <= std::exp(-2.0) && std::exp(-2.0) <= chance.high;
    held[6] += s->mean.low <= 1.0 && 1.0 <= s->mean.high;
  }
  const double slack = 4.0 * std::sqrt(0.95 * 0.05 * trials);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_GE(held[k], 0.95 * trials - slack) << k;
    EXPECT_LE(held[k], 0.995 * trials) << k;  // ranks are whole: at most half an interval too wide
  }
  EXPECT_GE(held[6], 0.93 * trials);  // Student's t assumes normal means; the skewness of 100 is 0.2
}

TEST(study_spread, main_effects_are_shares_of_the_variance) {
  // y = 2 a + b^2 of independent uniform numbers on [-1, 1]: 4/3 and 4/45.
  std::vector<double> one, other, y, flat;
  for (const auto& u : driver::sobol_sequence(1023, 2)) {
    one.push_back(2.0 * u[0] - 1.0), other.push_back(2.0 * u[1] - 1.0);
    y.push_back(2.0 * one.back() + other.back() * other.back()), flat.push_back(3.0);
  }
  const auto of_a = driver::trend(one, y), of_b = driver::trend(other, y);
  ASSERT_TRUE(of_a && of_b);
  const double all = 4.0 / 3.0 + 4.0 / 45.0;
  // Even points are far better than the independent ones that the intervals assume.
  EXPECT_NEAR(of_a->share.value, 4.0 / 3.0 / all, 0.002);
  EXPECT_NEAR(of_b->share.value, 4.0 / 45.0 / all, 0.002);
  for (const auto& [trend, truth] : {std::pair(*of_a, 4.0 / 3.0 / all), std::pair(*of_b, 4.0 / 45.0 / all)}) {
    EXPECT_LT(trend.share.low, truth);
    EXPECT_GT(trend.share.high, truth);
  }
  EXPECT_NEAR(of_a->change, 2.0 / std::sqrt(3.0), 0.002);  // deviation of a: 1 / sqrt(3)
  EXPECT_NEAR(of_a->at(0.5), 1.0 + 1.0 / 3.0, 0.01);
  EXPECT_NEAR(of_b->at(0.5), 0.25, 0.01);
  EXPECT_FALSE(driver::trend(flat, y));
  EXPECT_FALSE(driver::trend(one, flat));
  EXPECT_FALSE(driver::trend({1.0, 2.0, 3.0, 4.0}, {1.0, 2.0, 3.0, 5.0}));
  // A straight line without noise: all of the variance.
  const auto exact = driver::trend(one, one);
  EXPECT_NEAR(exact->share.value, 1.0, 1e-12);
  EXPECT_LE(exact->share.high, 1.0);
}

}  // namespace
