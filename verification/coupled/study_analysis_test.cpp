// SPDX-License-Identifier: Apache-2.0
// Designs and analyses of studies against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "many_runs/regression.hpp"
#include "many_runs/sampling.hpp"
#include "many_runs/sequential_test.hpp"
#include "many_runs/statistics.hpp"

namespace {

constexpr double pi = std::numbers::pi;

// Ishigami and Homma's function on [-pi, pi]^3; its indices are known (Saltelli et al., Global Sensitivity
// Analysis, 2008, p. 179): V = a^2/8 + b pi^4/5 + b^2 pi^8/18 + 1/2.
constexpr double a = 7.0, b = 0.1;
double ishigami(const driver::UnitPoint& unit) {
  const auto x = [&](std::size_t i) { return pi * (2.0 * unit[i] - 1.0); };
  return std::sin(x(0)) + a * std::pow(std::sin(x(1)), 2) + b * std::pow(x(2), 4) * std::sin(x(0));
}

TEST(study_analysis, sobol_indices_of_ishigami_lie_in_their_intervals) {
  std::vector<std::optional<double>> values;
  for (const auto& point : driver::sobol_index_points(2048, 3)) values.push_back(ishigami(point));
  const auto indices = driver::sobol_indices(values, 3);
  ASSERT_EQ(indices.size(), 3u);
  const double first = 0.5 * std::pow(1.0 + b * std::pow(pi, 4) / 5.0, 2), second = a * a / 8.0;
  const double mixed = 8.0 * b * b * std::pow(pi, 8) / 225.0;
  const double all = first + second + mixed;
  const double exact_first[] = {first / all, second / all, 0.0};
  const double exact_total[] = {(first + mixed) / all, second / all, mixed / all};
  for (std::size_t i = 0; i < 3; ++i) {
    // A Sobol sequence is off by far less than the independent samples that the intervals assume.
    EXPECT_GE(exact_first[i], indices[i].first_order.low) << i;
    EXPECT_LE(exact_first[i], indices[i].first_order.high) << i;
    EXPECT_GE(exact_total[i], indices[i].total.low) << i;
    EXPECT_LE(exact_total[i], indices[i].total.high) << i;
    EXPECT_LT(indices[i].total.high - indices[i].total.low, 0.15) << i;  // about 3 sd / sqrt(2048)
  }
}

TEST(study_analysis, rows_with_a_failed_run_are_left_out) {
  std::vector<std::optional<double>> values, without;
  const auto points = driver::sobol_index_points(64, 2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double value = points[i][0] + 3.0 * points[i][1];
    if (i >= 4) without.push_back(value);
    values.push_back(i == 2 ? std::nullopt : std::optional(value));  // in the first row of four
  }
  const auto some = driver::sobol_indices(values, 2), same = driver::sobol_indices(without, 2);
  ASSERT_EQ(some.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(some[i].total.value, same[i].total.value);
  EXPECT_TRUE(driver::sobol_indices(std::vector<std::optional<double>>(64, 1.0), 2).empty());
  EXPECT_TRUE(driver::sobol_indices(std::vector<std::optional<double>>(28, 1.0), 2).empty());  // 7 rows
}

TEST(study_analysis, latin_hypercube_has_one_point_in_each_interval) {
  const int count = 37;
  const auto points = driver::latin_hypercube(count, 4, 5);
  for (std::size_t f = 0; f < 4; ++f) {
    std::vector<int> cells;
    for (const auto& point : points) cells.push_back(static_cast<int>(std::floor(point[f] * count)));
    std::ranges::sort(cells);
    for (int i = 0; i < count; ++i) EXPECT_EQ(cells[static_cast<std::size_t>(i)], i);
  }
  EXPECT_EQ(points, driver::latin_hypercube(count, 4, 5));
  EXPECT_NE(points, driver::latin_hypercube(count, 4, 6));
}

TEST(study_analysis, sobol_sequence_fills_dyadic_boxes_evenly) {
  // The points 0 to 2^m - 1 have one point in each box of the first two dimensions; GSL leaves out point 0,
  // which stands in the box at the origin.
  const auto points = driver::sobol_sequence(63, 2);
  std::vector<int> boxes(64, 0);
  for (const auto& p : points)
    ++boxes[static_cast<std::size_t>(std::floor(8.0 * p[0])) * 8 +
            static_cast<std::size_t>(std::floor(8.0 * p[1]))];
  EXPECT_EQ(boxes[0], 0);
  EXPECT_EQ(std::ranges::count(boxes, 1), 63);
  EXPECT_THROW(driver::sobol_sequence(1, 41), std::invalid_argument);
  EXPECT_THROW(driver::sobol_index_points(1, 21), std::invalid_argument);
}

TEST(study_analysis, quadratic_is_fitted_exactly_and_noise_is_told) {
  const auto points = [] {
    std::vector<std::vector<double>> list;
    for (const auto& u : driver::latin_hypercube(60, 2, 1))
      list.push_back({2.0 * u[0] - 1.0, 2.0 * u[1] - 1.0});
    return list;
  }();
  std::vector<double> exact, noisy;
  std::mt19937_64 generator(3);
  std::normal_distribution<double> noise(0.0, 0.1);
  for (const auto& p : points) {
    exact.push_back(1.0 + 2.0 * p[0] - p[1] + 0.5 * p[0] * p[0] + 3.0 * p[0] * p[1] - 0.25 * p[1] * p[1]);
    noisy.push_back(exact.back() + noise(generator));
  }
  const double wanted[] = {1.0, 2.0, -1.0, 0.5, 3.0, -0.25};
  const auto surface = driver::fit_surface(points, exact), rough = driver::fit_surface(points, noisy);
  ASSERT_TRUE(surface && rough);
  ASSERT_EQ(surface->terms.size(), 6u);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_NEAR(surface->terms[k].coefficient, wanted[k],
                1e-13);  // eps * 60 * the matrix's condition, about 5
    EXPECT_NEAR(rough->terms[k].coefficient, wanted[k], 4.0 * rough->terms[k].standard_error) << k;
  }
  EXPECT_NEAR(surface->explained, 1.0, 1e-14);
  EXPECT_NEAR(rough->residual_deviation, 0.1,
              4.0 * 0.1 / std::sqrt(2.0 * 54.0));  // four of its standard errors
  EXPECT_FALSE(driver::fit_surface({{0.0}, {1.0}}, {1.0, 2.0}));
  EXPECT_FALSE(
      driver::fit_surface({{0.0}, {1.0}, {0.0}, {1.0}, {1.0}}, {1.0, 2.0, 1.0, 2.0, 2.0}));  // no square
}

TEST(study_analysis, convergence_finds_limit_and_order) {
  std::vector<double> sizes, values;
  for (const double h : {1.0, 0.5, 0.25, 0.125})
    sizes.push_back(h), values.push_back(3.0 - 0.7 * std::pow(h, 1.6));
  const auto fit = driver::fit_convergence(sizes, values);
  ASSERT_TRUE(fit);
  // The least of a sum of squares is found to the square root of eps.
  EXPECT_NEAR(fit->order, 1.6, 1e-5);
  EXPECT_NEAR(fit->limit, 3.0, 1e-6);
  EXPECT_NEAR(fit->coefficient, -0.7, 1e-6);
  EXPECT_LT(fit->residual, 1e-6);
  EXPECT_FALSE(driver::fit_convergence({1.0, 0.5}, {1.0, 2.0}));
  EXPECT_FALSE(driver::fit_convergence({1.0, 0.5, 0.25}, {1.0, 2.0, 5.0}));  // grows away
}

TEST(study_analysis, means_differ_beyond_errors_and_rounding) {
  const auto mean = [](double value, double error) {
    return driver::Statistics{value, error, value, value, 4};
  };
  const std::vector<driver::Statistics> some{mean(1.0, 0.3), mean(1.1, 0.0), mean(2.0, 0.4)};
  EXPECT_TRUE(driver::means_differ(some, 0.0));  // 1.1 and 2.0: 0.9 > 2 * 0.4
  EXPECT_FALSE(driver::means_differ(some, 1.5));
  EXPECT_FALSE(driver::means_differ(std::vector{mean(1.0, 0.3), mean(2.0, 0.4)}, 0.0));  // 1.0 = 2 * 0.5
  EXPECT_FALSE(driver::means_differ({}, 0.0));
}

TEST(study_analysis, values_left_out_move_a_mean_within_its_range) {
  const driver::Statistics s = driver::statistics({1.0, 2.0, 6.0});
  const auto none = driver::mean_with_left_out(s, 0), some = driver::mean_with_left_out(s, 2);
  ASSERT_TRUE(none && some);
  EXPECT_EQ(none->low, 3.0);
  EXPECT_EQ(none->high, 3.0);
  EXPECT_NEAR(some->low, (9.0 + 2.0 * 1.0) / 5.0, 1e-15);  // a few roundings of numbers up to 6
  EXPECT_NEAR(some->high, (9.0 + 2.0 * 6.0) / 5.0, 2e-15);
  EXPECT_TRUE(driver::mean_with_left_out(driver::statistics({4.0}), 0));
  EXPECT_FALSE(driver::mean_with_left_out(driver::statistics({4.0}), 1));
  EXPECT_FALSE(driver::mean_with_left_out(driver::statistics({}), 0));
}

// Of samples without a difference, looked at ten times, at most the stated share is called decided.
TEST(study_analysis, sequential_sign_test_keeps_its_error_rate) {
  std::mt19937_64 generator(11);
  std::normal_distribution<double> normal;
  constexpr int tests = 4000, looks = 6;
  constexpr double rate = 0.05;
  int wrong = 0, found = 0;
  for (int t = 0; t < tests; ++t) {
    std::vector<double> none, some;
    bool decided = false, seen = false;
    for (int look = 0, seeds = 8; look < looks; ++look, seeds *= 2) {
      while (static_cast<int>(none.size()) < seeds) none.push_back(normal(generator));
      decided = decided || driver::sign_is_decided(none, looks, rate);
    }
    for (int look = 0, seeds = 8; look < looks && !seen; ++look, seeds *= 2) {
      while (static_cast<int>(some.size()) < seeds) some.push_back(0.5 + normal(generator));
      seen = driver::sign_is_decided(some, looks, rate);
    }
    wrong += decided;
    found += seen;
  }
  EXPECT_LE(wrong, rate * tests);  // Bonferroni is on the safe side
  EXPECT_GT(wrong, 0.2 * rate * tests);
  EXPECT_GT(found, 0.99 * tests);  // 256 seeds see half a standard deviation
}

TEST(study_analysis, looks_double_the_runs) {
  EXPECT_EQ(driver::looks(16, 0), 1);
  EXPECT_EQ(driver::looks(16, 64), 3);
  EXPECT_EQ(driver::looks(16, 65), 4);
  EXPECT_EQ(driver::next_look(32, 65), 64);
  EXPECT_EQ(driver::next_look(64, 65), 65);
}

}  // namespace
