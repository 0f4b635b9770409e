// SPDX-License-Identifier: Apache-2.0
// What a ladder makes of values and costs that are given.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "many_runs/ladder.hpp"

namespace {

using driver::LadderResult;
using driver::LadderRung;
using driver::Verdict;

driver::Statistics number(double value, double standard_error = 0.0) {
  return {value, standard_error, value, value, 16};
}

TEST(ladder, remainder_of_a_power_of_the_step_is_its_limit) {
  for (const double order : {1.0, 2.0, 4.0}) {
    const auto value = [&](int level) { return number(3.0 + 0.7 * std::pow(0.5, order * level)); };
    const auto rest = driver::remainder({value(0), value(1), value(2)}, 1, driver::AxisKind::halving);
    // Differences of three numbers near 3, the second over 2^order - 1 at most: some ten roundings of 4e-16.
    EXPECT_NEAR(value(1).mean + rest.correction, 3.0, 1e-14) << order;
    ASSERT_TRUE(rest.order.has_value()) << order;
    // d ln(d1 / d2): those roundings over the smallest difference, 0.7 (2^-4 - 2^-8) = 0.04.
    EXPECT_NEAR(*rest.order, order, 1e-12);
    EXPECT_GE(rest.uncertainty * (1.0 + 1e-12), std::abs(value(2).mean - 3.0))
        << "covers what the finest is off by";
  }
}

TEST(ladder, remainder_without_an_order_adds_nothing) {
  using driver::AxisKind;
  const std::vector<driver::Statistics> turning{number(1.0), number(2.0), number(1.5)};
  const std::vector<driver::Statistics> noisy{number(1.0, 0.3), number(1.4, 0.3), number(1.6, 0.3)};
  const std::vector<driver::Statistics> clean{number(1.0), number(1.4), number(1.6)};
  for (const auto& values : {turning, noisy}) {
    const auto rest = driver::remainder(values, 1, AxisKind::halving);
    EXPECT_FALSE(rest.order.has_value());
    EXPECT_EQ(rest.correction, 0.0);
    EXPECT_EQ(rest.uncertainty, 2.0 * std::abs(values[2].mean - values[1].mean));
  }
  EXPECT_TRUE(driver::remainder(clean, 1, AxisKind::halving).order.has_value());
  EXPECT_FALSE(driver::remainder(clean, 1, AxisKind::tightening).order.has_value());
  EXPECT_EQ(driver::remainder({number(1.0), number(1.4)}, 1, AxisKind::halving).uncertainty, 1.4 - 1.0);
}

// The limit y2 + (y2 - y1)^2 / (2 y1 - y0 - y2) changes by 1, -4 and 4 with y0, y1 and y2 at order 1; the
// remainder beyond y1 by one less with that.
TEST(ladder, remainder_carries_the_errors_of_its_values) {
  const double e = 1e-3;
  const auto rest =
      driver::remainder({number(4.0, e), number(2.0, e), number(1.0, e)}, 1, driver::AxisKind::halving);
  EXPECT_NEAR(rest.standard_error, e * std::sqrt(1.0 + 25.0 + 16.0), 1e-15);  // some roundings of 6e-3
}

// A chaotic full case and a coarser choice, by hand: costs and values are given.
LadderResult two_rungs(int runs_of_full, int runs_of_other) {
  LadderResult result;
  result.chaotic = true;
  for (const int runs : {runs_of_full, runs_of_other}) {
    LadderRung rung;
    rung.can_be_perturbed = true;
    rung.value = {1.0, 0.001, 0.99, 1.01, runs};
    rung.cpu_seconds = result.rungs.empty() ? 2.0 : 1.0;
    result.rungs.push_back(rung);
  }
  return result;
}

// An assumption of the model moves the full case by `change`; it is as cheap as can be.
LadderResult with_assumption(double change) {
  LadderResult result = two_rungs(16, 16);
  result.plan.axes.push_back({"reflection", driver::AxisKind::model, {{"as it is", {}}, {"none", {}}}, 0, 0});
  LadderRung rung = result.rungs.front();
  rung.name = "none";
  rung.axis = 0;
  rung.choice = 1;
  rung.value.mean += change;
  rung.cpu_seconds = 0.1;
  result.rungs.push_back(rung);
  return result;
}

TEST(ladder, assumptions_are_not_judged_but_say_whether_the_verdict_stands) {
  for (const double change : {-0.3, -0.05, 0.02, 0.3}) {
    LadderResult result = with_assumption(change);
    driver::judge(result, 0.1);
    EXPECT_EQ(result.cheapest, std::optional<std::size_t>(1)) << "not the assumption, which is cheaper";
    EXPECT_EQ(result.rungs[2].verdict, Verdict::not_judged);
    EXPECT_EQ(result.rungs[2].front, 0);
    ASSERT_TRUE(result.model.has_value());
    EXPECT_NEAR(result.model->low, std::min(change, 0.0), 1e-15);
    EXPECT_NEAR(result.model->high, std::max(change, 0.0), 1e-15);
    EXPECT_EQ(change < 0.0 ? result.model->lowest : result.model->highest, "none");
    EXPECT_EQ(result.model->cheapest_stands, std::abs(change) < 0.1);
  }
  LadderResult without = two_rungs(16, 16);
  driver::judge(without, 0.1);
  EXPECT_FALSE(without.model.has_value());
}

TEST(ladder, judgement_names_the_cheaper_and_needs_runs_of_both) {
  LadderResult enough = two_rungs(16, 16), few_of_full = two_rungs(15, 16);
  driver::judge(enough, 0.1);
  driver::judge(few_of_full, 0.1);
  EXPECT_EQ(enough.cheapest, std::optional<std::size_t>(1));
  EXPECT_EQ(few_of_full.rungs[1].verdict, Verdict::undecided);
  EXPECT_EQ(few_of_full.verdict, Verdict::undecided);
}

// Student's t of 15 degrees of freedom, one-sided: 2.1314 for 0.025 and 3.2860 for 0.0025 (any table).
TEST(ladder, verdict_allows_for_students_t) {
  const double error = 0.001 * std::sqrt(2.0);  // of a difference of two means
  struct Given {
    double rate, allowed_errors;
  };
  for (const auto& [rate, allowed_errors] : {Given{0.025, 2.1314}, Given{0.0025, 3.2860}}) {
    for (const double share : {0.999, 1.001}) {
      LadderResult near_inside = two_rungs(16, 16), near_outside = two_rungs(16, 16);
      near_inside.rungs[1].value.mean = 1.01 - share * allowed_errors * error;
      near_outside.rungs[1].value.mean = 1.01 + share * allowed_errors * error;
      driver::judge(near_inside, 0.01, rate);
      driver::judge(near_outside, 0.01, rate);
      EXPECT_EQ(near_inside.rungs[1].verdict, share > 1.0 ? Verdict::inside : Verdict::undecided) << rate;
      EXPECT_EQ(near_outside.rungs[1].verdict, share > 1.0 ? Verdict::outside : Verdict::undecided) << rate;
    }
  }
}

// What the error may be off by is 2.1314 standard errors of the difference, 0.0014 each: 0.2 of 0.015073.
TEST(ladder, verdict_is_on_the_bound_where_the_error_lies_within_a_fifth_of_it) {
  for (const double allowed : {0.01506, 0.01508})
    for (const double side : {-1.0, 1.0}) {
      LadderResult result = two_rungs(16, 16);
      result.rungs[1].value.mean = 1.0 + side * allowed;
      driver::judge(result, allowed);
      EXPECT_EQ(result.rungs[1].verdict, allowed > 0.01507 ? Verdict::on_the_bound : Verdict::undecided);
      EXPECT_EQ(result.cheapest, std::optional<std::size_t>(0));
      EXPECT_TRUE(driver::open_rungs(result, allowed).empty() == (allowed > 0.01507));
    }
}

// Two rungs, the second undecided: its error is off the allowed 0.1 by 0.01.
LadderResult undecided(double own_error, double reference_error, double uncertainty) {
  LadderResult result = two_rungs(16, 16);
  result.reference = {1.0, reference_error, uncertainty, {}};
  result.rungs[0].value.standard_error = reference_error;
  result.rungs[0].verdict = Verdict::inside;
  result.rungs[1].value.standard_error = own_error;
  result.rungs[1].verdict = Verdict::undecided;
  result.rungs[1].error = 0.11;
  return result;
}

TEST(ladder, open_rungs_are_those_whose_runs_can_decide) {
  using Rungs = std::vector<std::size_t>;
  EXPECT_EQ(driver::open_rungs(undecided(0.02, 0.001, 0.0), 0.1), (Rungs{1}));
  EXPECT_EQ(driver::open_rungs(undecided(0.02, 0.02, 0.0), 0.1), (Rungs{0, 1}));
  EXPECT_EQ(driver::open_rungs(undecided(0.001, 0.02, 0.0), 0.1), (Rungs{0}));
  // An uncertainty of 0.02 keeps the verdict open whatever the runs say, unless it is scatter itself.
  EXPECT_EQ(driver::open_rungs(undecided(0.02, 0.001, 0.02), 0.1), Rungs{});
  EXPECT_EQ(driver::open_rungs(undecided(0.02, 0.02, 0.02), 0.1), (Rungs{0}));
}

TEST(ladder, finer_meshes_make_the_finest_rung_finer) {
  const char* file = GASJET_SOURCE_DIR "/cases/jet_bag.toml";
  for (const int finer : {1, 2}) {
    const auto plan = driver::plan_ladder(file, {}, "peak_pressure", {}, finer);
    const auto picks = driver::finest_picks(plan);
    for (std::size_t a = 0; a < plan.axes.size(); ++a)
      if (plan.axes[a].name == "mesh") {
        EXPECT_EQ(plan.axes[a].choices.size(), plan.axes[a].base + static_cast<std::size_t>(finer) + 1);
        EXPECT_EQ(picks[a], plan.axes[a].base + static_cast<std::size_t>(finer));
      }
  }
}

// Costs and values by hand, the full case first and exact: those on the front by cost have places 1, 2, 3.
TEST(ladder, front_is_what_is_more_exact_than_all_that_is_cheaper) {
  struct Given {
    double cost, value;
    int place;
  };
  // Within a tolerance of 0.1 an error of 5e-5 is below its thousandth: as good as none.
  const Given given[] = {{8.0, 1.0, 0}, {4.0, 1.0 - 5e-5, 3}, {1.0, 1.3, 1},
                         {2.0, 0.6, 0}, {3.0, 0.9, 2},        {3.5, 1.2, 0}};
  LadderResult result;
  for (const Given& g : given) {
    LadderRung rung;
    rung.value = number(g.value);
    rung.cpu_seconds = g.cost;
    result.rungs.push_back(rung);
  }
  result.rungs.emplace_back().failure = "left its domain";
  driver::judge(result, 0.1);
  for (std::size_t i = 0; i < std::size(given); ++i) EXPECT_EQ(result.rungs[i].front, given[i].place) << i;
  EXPECT_EQ(result.rungs.back().front, 0) << "has no value";
}

}  // namespace
