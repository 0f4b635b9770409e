// SPDX-License-Identifier: Apache-2.0
// What happens at and past the largest stable step.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "membrane/time_step.hpp"
#include "run_case.hpp"

namespace {

using coupled::run_case;

TEST(step_limit, step_above_bound_fails_before_the_first_step) {
  const auto run = run_case("sphere_inflation", {"time.step=1e-3"});
  EXPECT_EQ(run.outcome.status, driver::RunStatus::failed);
  EXPECT_EQ(run.state.steps, 0);
  EXPECT_TRUE(run.history.empty());
  for (const char* word :
       {"time.step = 0.001 s is unstable", "the limit is ", "fabric ", "stiffest element", "Lower time.step"})
    EXPECT_NE(run.outcome.message.find(word), std::string::npos) << run.outcome.message;
}

std::vector<std::string> fixed_step(double step) {
  return {"time.step=" + std::to_string(step * 1e6) + "e-6", "time.unsafe_step=true",
          "gas.initial.pressure=121325.0"};
}

// Bound of the scene at the start [s].
double bound_at_start() {
  const auto scene = coupled::scene_of("sphere_inflation", {"gas.initial.pressure=121325.0"});
  driver::State state = driver::make_state(scene);
  driver::step(scene, state, {});
  return state.step.critical;
}

TEST(step_limit, stable_below_the_bound_and_blown_up_well_above) {
  const double bound = bound_at_start();
  // The sphere stretches by some percent, and the bound with it falls: 0.9 keeps below it for the whole run.
  const auto below = run_case("sphere_inflation", fixed_step(0.9 * bound));
  EXPECT_EQ(below.outcome.status, driver::RunStatus::done) << below.outcome.message;
  EXPECT_LT(below.state.peaks.energy_residual, 1e-3 * below.state.flows.enthalpy_in);
  // The bound is of single elements, 0.80 to 0.82 of the assembled limit of an icosphere: 1.7 is past it for
  // certain.
  const auto above = run_case("sphere_inflation", fixed_step(1.7 * bound));
  EXPECT_EQ(above.outcome.status, driver::RunStatus::failed);
}

TEST(step_limit, blow_up_is_caught_and_the_history_kept_finite) {
  const auto run = run_case("sphere_inflation", fixed_step(5.0 * bound_at_start()));
  EXPECT_EQ(run.outcome.status, driver::RunStatus::failed);
  EXPECT_FALSE(run.history.empty());
  EXPECT_NE(run.outcome.message.find("stage S"), std::string::npos) << run.outcome.message;
  for (const auto& row : run.history) {
    EXPECT_TRUE(std::isfinite(row.at("pressure_Pa")));
    EXPECT_TRUE(std::isfinite(row.at("volume_m3")));
  }
}

// The limit may be typed as it is printed.
TEST(step_limit, printed_limit_is_accepted) {
  const auto run = run_case("sphere_inflation", {"time.step=1e-3"});
  const std::string text = run.outcome.message;
  const auto begin = text.find("the limit is ") + 13;
  const std::string limit = text.substr(begin, text.find(" s", begin) - begin);
  EXPECT_GT(run_case("sphere_inflation", {"time.step=" + limit}).state.steps, 0) << text;
}

struct Level {
  double step, rate;  // [s] that leaves it, [1/s] of the velocities half a step later
  long limited;
};
std::vector<Level> levels_of(const driver::Scene& scene) {
  driver::State state = driver::make_state(scene);
  std::vector<Level> levels;
  const auto record = [&](bool, const driver::State& now) {
    levels.push_back({now.step.after, membrane::deformation_rate(scene.bag->model, *now.bag).rate,
                      now.step.deformation_limited + now.step.drift_limited});
  };
  const auto outcome = driver::run_scene(scene, state, record);
  EXPECT_EQ(outcome.status, driver::RunStatus::done) << outcome.message;
  return levels;
}

// (M.33), but where another limit made the step before shorter.
TEST(step_limit, step_grows_by_at_most_2e_4) {
  for (const char* name : {"passenger_pendulum_no_jet", "driver_bag"}) {
    const auto levels = levels_of(coupled::scene_of(name, {"scene.end_time=0.02"}));
    ASSERT_GT(levels.size(), 200U);
    for (std::size_t n = 2; n + 101 < levels.size(); ++n) {
      const bool alone = levels[n - 1].limited == levels[n - 2].limited;
      EXPECT_LE(levels[n].step, (alone ? 1.0002 : 2.0) * levels[n - 1].step * (1.0 + 1e-12))
          << name << ' ' << n;
    }
  }
}

// (M.32) of slivers that bounce.
TEST(step_limit, no_step_changes_the_deformation_by_more_than_0_4) {
  driver::CaseDocument document(GASJET_SOURCE_DIR "/verification/foreign/slivers/hull_120_3.toml", {});
  const auto levels = levels_of(driver::load_scene(document));
  EXPECT_GT(levels.back().limited, 0);
  for (std::size_t n = 1; n + 1 < levels.size(); ++n)  // no step leaves the last level
    EXPECT_LE(levels[n - 1].rate * levels[n].step, 0.4 * (1.0 + 1e-12)) << n;
}

// A given step is kept, and its worst change stands in the summary.
TEST(step_limit, given_step_is_not_cut_by_the_deformation) {
  driver::CaseDocument document(GASJET_SOURCE_DIR "/verification/foreign/slivers/hull_120_3.toml",
                                {"time.step=3e-6", "scene.end_time=0.015"});
  const auto scene = driver::load_scene(document);
  double worst = 0.0, before = 0.0;
  driver::State state = driver::make_state(scene);
  const auto record = [&](bool, const driver::State& now) {
    worst = std::max(worst, before * now.step.after);
    before = membrane::deformation_rate(scene.bag->model, *now.bag).rate;
  };
  EXPECT_EQ(driver::run_scene(scene, state, record).status, driver::RunStatus::done);
  EXPECT_NEAR(state.step.minimum, 3e-6, 1e-12);
  EXPECT_GT(worst, 0.1);
  EXPECT_NEAR(state.step.deformation, worst, 1e-9 * worst);
}

TEST(step_limit, shares_sum_to_one_in_the_mean) {
  const auto run = run_case("passenger_pendulum_no_jet", {"scene.end_time=0.02"});
  const auto& s = run.state.step.share_sums;
  // A sum of as many ones as there are steps, each rounded.
  EXPECT_NEAR(s.total() / static_cast<double>(run.state.steps), 1.0, 1e-12);
  EXPECT_GT(s.element, s.gas);
}

TEST(step_limit, run_ends_at_the_end) {
  for (const char* end : {"scene.end_time=0.00123", "scene.end_time=1e-5", "scene.end_time=0.002"}) {
    const auto run = run_case("sphere_inflation", {end});
    EXPECT_EQ(run.history.back().at("time_s"), std::stod(std::string(end).substr(15)));
    EXPECT_EQ(run.state.time, run.history.back().at("time_s"));
  }
}

// Ten steps of 0.01 s sum up to 2^-56 s less than 0.1 s: that is no eleventh step.
TEST(step_limit, rounding_of_the_time_leaves_no_sliver) {
  const auto run = run_case("pendulum_swing", {"time.step=0.01", "scene.end_time=0.1"});
  EXPECT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  EXPECT_EQ(run.state.time, 0.1);
  EXPECT_NEAR(run.state.step.minimum, 0.01, 1e-9 * 0.01);  // by which the last step may differ
}

/// Rows on the multiples, whatever the step; the last at the end.
TEST(step_limit, exact_history_lands_on_its_multiples) {
  for (const auto& [name, every] : {std::pair{"sphere_inflation", 1e-4},
                                    {"jet_bag", 7e-4},
                                    {"pendulum_swing", 0.003},
                                    {"rigid_tank", 7e-4}}) {
    const auto run =
        run_case(name, {"output.history_exact=true", fmt::format("output.history_every={}", every)});
    ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
    const double end = coupled::scene_of(name).time.end;
    const auto last = run.history.size() - 1;
    ASSERT_EQ(last, static_cast<std::size_t>(std::ceil(end / every * (1.0 - 1e-12)))) << name;
    for (std::size_t k = 0; k < last; ++k)
      EXPECT_NEAR(run.history[k].at("time_s"), static_cast<double>(k) * every, 1e-15 * end) << name;
    EXPECT_EQ(run.history[last].at("time_s"), end) << name;
  }
}

/// Its steps are no longer than those of the default run, so it is as close to the run of half the step.
TEST(step_limit, exact_history_keeps_the_results) {
  for (const char* name : {"sphere_inflation", "jet_bag"}) {
    const auto end_of = [&](const std::string& setting) { return run_case(name, {setting}).history.back(); };
    const auto fine = end_of("time.safety=0.4"), usual = end_of("time.safety=0.95"),
               exact = end_of("output.history_exact=true");
    for (const char* column : {"pressure_Pa", "volume_m3"})
      EXPECT_LT(std::abs(exact.at(column) - fine.at(column)), std::abs(usual.at(column) - fine.at(column)));
  }
}

}  // namespace
