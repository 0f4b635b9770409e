// SPDX-License-Identifier: Apache-2.0
// `gasjet compare` against a mean of many runs: Student's test against its closed forms of 2 and 4 degrees of
// freedom, its rates of error by random numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "compare/compare.hpp"
#include "engine/channel_filter.hpp"
#include "many_runs/ensemble.hpp"
#include "run_case.hpp"

namespace {

using driver::Difference;
using driver::History;
using driver::Verdict;

constexpr double kScatter = 3.0;  // of a run
constexpr int kRows = 11;
constexpr double kRate = 0.01;  // of false alarms, over all rows

// Quantiles of Student's distribution: of 2 degrees of freedom, and of 4 (Shaw, J. Comput. Finance 9(4),
// 2006).
double quantile_2(double p) {
  return (2.0 * p - 1.0) * std::sqrt(2.0 / (4.0 * p * (1.0 - p)));
}
double quantile_4(double p) {
  const double a = 4.0 * p * (1.0 - p);
  return 2.0 * std::sqrt(std::cos(std::acos(std::sqrt(a)) / 3.0) / std::sqrt(a) - 1.0);
}

// A ramp to 1000 over kRows rows, `off` too high in its last row.
History ramp(double off, int runs, double scatter = kScatter) {
  History history;
  history.runs = runs;
  history.columns.emplace_back("force_N", std::vector<double>{});
  for (int i = 0; i < kRows; ++i) {
    history.time.push_back(0.1 * i);
    history.columns[0].second.push_back(1000.0 * i / (kRows - 1) + (i == kRows - 1 ? off : 0.0));
  }
  if (runs > 1)
    history.columns.emplace_back("force_N_standard_error",
                                 std::vector<double>(kRows, scatter / std::sqrt(double(runs))));
  return history;
}

void expect_limit(int runs, int reference_runs, double student, double student_of_power) {
  const double error = kScatter * std::sqrt(1.0 / runs + 1.0 / reference_runs);
  const History reference = ramp(0.0, reference_runs);
  const double limit = student * error + 1e-6 * 1000.0;  // round-off of means that are written
  const Difference below = driver::compare(ramp(limit * (1.0 - 1e-6), runs), reference);
  EXPECT_EQ(below.verdict, Verdict::inside) << below.reason;
  EXPECT_EQ(below.runs, runs);
  EXPECT_EQ(below.reference_runs, reference_runs);
  EXPECT_EQ(driver::compare(ramp(limit * (1.0 + 1e-6), runs), reference).verdict, Verdict::outside);
  ASSERT_TRUE(below.quantities[0].seen);
  EXPECT_NEAR(*below.quantities[0].seen * 1000.0, limit + student_of_power * error, 1e-6 * limit);
}

// A blow of 20 ms beside a swing: what a filter takes off and what it lets through.
History blow(double interval) {
  History history;
  history.columns = {{"pendulum_cg_tangential_m_s2", {}}, {"pendulum_cg_radial_m_s2", {}}};
  for (int i = 0; i * interval <= 0.1; ++i) {
    const double t = i * interval;
    history.time.push_back(t);
    history.columns[0].second.push_back(t > 0.03 && t < 0.05 ? 200.0 + 90.0 * std::sin(6000.0 * t) : 0.0);
    history.columns[1].second.push_back(10.0 + 50.0 * t);
  }
  return history;
}

TEST(compare_ensemble, run_is_filtered_as_the_reference_is) {
  const History mine = blow(1e-4);
  History reference{mine.time, {}};
  for (const int channel_class : {60, 180, 600, 1000}) {
    auto values = driver::filtered_resultant({mine.time, mine.columns[0].second, mine.columns[1].second},
                                             channel_class);
    const auto name = driver::filtered_column(channel_class);
    reference.columns.emplace_back(name, values);
    reference.columns.emplace_back(name + "_band", std::vector<double>(values.size(), 1e-9));
  }
  EXPECT_EQ(driver::compare(mine, reference).verdict, Verdict::inside);
  reference.columns[2].second[400] *= 1.0 + 1e-6;
  EXPECT_EQ(driver::compare(mine, reference).verdict, Verdict::outside);
  // Rows that are too few for the class do not stand for the filtered signal.
  const Difference coarse = driver::compare(blow(1e-3), reference, {"pendulum_cg_acceleration_cfc180_m_s2"});
  EXPECT_NE(coarse.verdict, Verdict::inside);
  EXPECT_NE(coarse.verdict, Verdict::outside);
  ASSERT_FALSE(coarse.quantities.empty());
  EXPECT_EQ(coarse.quantities[0].reason, "mine has rows 0.001 s apart, CFC 180 needs 0.000555 s or less");
}

TEST(compare_ensemble, rows_of_an_ensemble_end_with_the_filtered_acceleration) {
  driver::EnsembleOptions one;
  one.runs = 1;
  one.quiet = true;
  const auto result = driver::run_ensemble(coupled::case_file("passenger_sharp"),
                                           {"scene.end_time=0.03", "output.channel_classes=[180,600]"}, one);
  const std::size_t columns = result.columns.size();
  ASSERT_GE(columns, 3U);
  EXPECT_EQ(result.columns[columns - 3], driver::filtered_column(60));
  ASSERT_EQ(result.columns[columns - 2], driver::filtered_column(180));
  ASSERT_EQ(result.columns[columns - 1], driver::filtered_column(600));
  ASSERT_FALSE(result.rows.empty());
  double largest = 0.0, wider = 0.0;
  for (const auto& row : result.rows) {
    largest = std::max(largest, row.values[columns - 2].mean);
    wider = std::max(wider, row.values[columns - 1].mean);
  }
  EXPECT_GT(wider, largest);  // what lets more through has the higher peak
  const double peak = result.quantities.at("peak_cg_acceleration_cfc180_m_s2").front();
  EXPECT_LE(largest, peak * (1.0 + 1e-12));
  EXPECT_GT(largest, 0.99 * peak);  // rows are every 0.1 ms
}

TEST(compare_ensemble, limit_of_a_run_eq_quantile_of_2_degrees) {
  expect_limit(1, 3, quantile_2(1.0 - kRate / (2.0 * kRows)), quantile_2(0.9));
}

TEST(compare_ensemble, limit_of_two_means_eq_quantile_of_4_degrees) {
  expect_limit(3, 3, quantile_4(1.0 - kRate / (2.0 * kRows)), quantile_4(0.9));
  expect_limit(2, 4, quantile_4(1.0 - kRate / (2.0 * kRows)), quantile_4(0.9));
}

// Scatters 1 and 5 of three runs each: the variance of all is the mean of both.
TEST(compare_ensemble, scatter_is_pooled) {
  const double error = std::sqrt(13.0) * std::sqrt(2.0 / 3.0);
  const double limit = quantile_4(1.0 - kRate / (2.0 * kRows)) * error + 1e-3;
  EXPECT_EQ(driver::compare(ramp(0.999999 * limit, 3, 1.0), ramp(0.0, 3, 5.0)).verdict, Verdict::inside);
  EXPECT_EQ(driver::compare(ramp(1.000001 * limit, 3, 1.0), ramp(0.0, 3, 5.0)).verdict, Verdict::outside);
}

// Rows lie a tenth of the times apart here, so a neighbour's scatter does not count; 51 rows lie a fiftieth
// apart.
TEST(compare_ensemble, scatter_of_neighbours_counts_within_a_fiftieth_of_the_times) {
  History reference, mine;
  reference.runs = 3;
  for (auto* history : {&reference, &mine}) history->columns.emplace_back("force_N", std::vector<double>{});
  reference.columns.emplace_back("force_N_standard_error", std::vector<double>(51, 0.0));
  for (int i = 0; i < 51; ++i)
    for (auto* history : {&reference, &mine}) {
      history->time.push_back(0.25 * i);
      history->columns[0].second.push_back(100.0 * i);
    }
  reference.columns[1].second[20] = 1.0;
  for (const int row : {19, 20, 21, 18, 22}) {
    History off = mine;
    off.columns[0].second[static_cast<std::size_t>(row)] += 10.0;  // chance may do 23
    EXPECT_EQ(driver::compare(off, reference).verdict,
              std::abs(row - 20) <= 1 ? Verdict::inside : Verdict::outside)
        << row;
  }
}

TEST(compare_ensemble, band_and_tolerance_are_added) {
  History reference = ramp(0.0, 3);
  reference.columns.emplace_back("force_N_band", std::vector<double>(kRows, 7.0));
  const double chance = quantile_2(1.0 - kRate / (2.0 * kRows)) * kScatter * std::sqrt(4.0 / 3.0) + 1e-3;
  const double limit = chance + 7.0 + 0.002 * 1000.0;
  EXPECT_EQ(driver::compare(ramp(limit - 1e-3, 1), reference, {}, 0.002).verdict, Verdict::inside);
  EXPECT_EQ(driver::compare(ramp(limit + 1e-3, 1), reference, {}, 0.002).verdict, Verdict::outside);
}

// A scatter of the signal's size: nothing to be inside of, unless the run is far off.
TEST(compare_ensemble, what_scatter_hides_is_not_judged) {
  const Difference hidden = driver::compare(ramp(0.0, 1), ramp(0.0, 3, 1000.0));
  EXPECT_EQ(hidden.quantities[0].verdict, Verdict::not_judged);
  EXPECT_EQ(hidden.verdict, Verdict::undecided);
  EXPECT_GT(*hidden.quantities[0].seen, 1.0);
  EXPECT_EQ(driver::compare(ramp(1e6, 1), ramp(0.0, 3, 1000.0)).verdict, Verdict::outside);
  // A mean whose scatter nobody knows.
  History mean = ramp(0.0, 5);
  mean.columns.pop_back();
  EXPECT_EQ(driver::compare(mean, ramp(0.0, 3)).verdict, Verdict::undecided);
}

// Samples of normal numbers, 8 runs and 4, 20 rows.
TEST(compare_ensemble, one_of_a_hundred_samples_of_one_scene_is_outside) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  constexpr int pairs = 3000, rows = 20;
  const auto mean_of = [&](int runs) {
    History history;
    history.runs = runs;
    history.columns.emplace_back("force_N", std::vector<double>{});
    history.columns.emplace_back("force_N_standard_error", std::vector<double>{});
    for (int i = 0; i < rows; ++i) {
      double sum = 0.0, squares = 0.0;
      for (int r = 0; r < runs; ++r) {
        const double x = normal(random);
        sum += x;
        squares += x * x;
      }
      const double mean = sum / runs;
      history.time.push_back(i);
      history.columns[0].second.push_back(1000.0 * i / (rows - 1) + mean);
      history.columns[1].second.push_back(std::sqrt((squares / runs - mean * mean) / (runs - 1)));
    }
    return history;
  };
  int alarms = 0;
  for (int k = 0; k < pairs; ++k) {
    const History reference = mean_of(8);
    alarms += driver::compare(mean_of(4), reference).verdict == Verdict::outside;
  }
  // Twenty independent rows make 1 - (1 - 0.01/20)^20 = 0.00995; four standard deviations of a count;
  // round-off as a share of the peak makes a few less.
  EXPECT_NEAR(alarms, 0.00995 * pairs, 4.0 * std::sqrt(0.00995 * pairs));
}

// With a scatter that is known (many runs), a change of the size that it states is seen in nine of ten cases.
TEST(compare_ensemble, power_is_as_stated) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  constexpr int pairs = 800, runs = 1000000;
  int seen = 0;
  for (int k = 0; k < pairs; ++k) {
    const History reference = ramp(normal(random), runs, std::sqrt(double(runs)));  // standard error 1
    const double change = *driver::compare(reference, reference).quantities[0].seen * 1000.0;
    const History mine = ramp(normal(random) + change, runs, std::sqrt(double(runs)));
    seen += driver::compare(mine, reference).verdict == Verdict::outside;
  }
  EXPECT_NEAR(seen, 0.9 * pairs, 4.0 * std::sqrt(0.09 * pairs));
}

}  // namespace
