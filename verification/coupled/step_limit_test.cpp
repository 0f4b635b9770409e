// SPDX-License-Identifier: Apache-2.0
// What happens at and past the largest stable step.
#include <gtest/gtest.h>

#include <cmath>

#include "run_case.hpp"

namespace {

using coupled::run_case;

TEST(step_limit, step_above_bound_fails_before_the_first_step) {
  const auto run = run_case("sphere_inflation", {"time.step=1e-3"});
  EXPECT_EQ(run.outcome.status, driver::RunStatus::failed);
  EXPECT_EQ(run.state.steps, 0);
  EXPECT_TRUE(run.history.empty());
  for (const char* word : {"step 0.001 s", "above its bound", "fabric", "gas", "element"})
    EXPECT_NE(run.outcome.message.find(word), std::string::npos) << run.outcome.message;
}

TEST(step_limit, unsafe_step_blows_up_and_is_caught) {
  const auto run = run_case("sphere_inflation",
                            {"time.step=4e-4", "time.unsafe_dt=true", "gas.initial.pressure=121325.0"});
  EXPECT_EQ(run.outcome.status, driver::RunStatus::failed);
  EXPECT_FALSE(run.history.empty());
  EXPECT_NE(run.outcome.message.find("stage S"), std::string::npos) << run.outcome.message;
  for (const auto& row : run.history) {
    EXPECT_TRUE(std::isfinite(row.pressure_Pa));
    EXPECT_TRUE(std::isfinite(row.volume_m3));
  }
}

TEST(step_limit, unsafe_step_below_the_bound_is_stable) {
  // Same scene, a step at 0.99 of the bound at the start: the control of the test above.
  const auto run = run_case("sphere_inflation",
                            {"time.step=2e-5", "time.unsafe_dt=true", "gas.initial.pressure=121325.0"});
  EXPECT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  EXPECT_LT(run.state.peaks.energy_residual, 1e-3 * run.state.flows.enthalpy_in);
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
    EXPECT_EQ(run.history.back().time_s, std::stod(std::string(end).substr(15)));
    EXPECT_EQ(run.state.time, run.history.back().time_s);
  }
}

}  // namespace
