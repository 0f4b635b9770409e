// SPDX-License-Identifier: Apache-2.0
// No allocation inside a step.
#include <gtest/gtest.h>

#include "run_case.hpp"
#include "support/allocation_counter.hpp"

namespace {

long allocations_of_steps(const driver::Scene& scene, driver::State& state, int warm_up, int steps) {
  driver::StepRecords records;
  const auto advance = [&](int count) {
    for (int i = 0; i < count; ++i) {
      driver::step(scene, state, {}, records);
      state.time += state.step.after;
      ++state.steps;
    }
  };
  advance(warm_up);
  const long before = support::allocations();
  advance(steps);
  return support::allocations() - before;
}

TEST(allocation, none_inside_a_step) {
  for (const char* name : {"passenger_pendulum", "passenger_pendulum_no_jet", "ball_impact", "sphere_inflation",
                           "tank_blowdown", "plate_jet"}) {
    const auto scene = coupled::scene_of(name);
    driver::State state = driver::make_state(scene);
    // The first step may still fill the workspace of the contact search.
    EXPECT_EQ(allocations_of_steps(scene, state, 1, 300), 0) << name;
    if (std::string(name) != "passenger_pendulum") continue;
    // The scene did what could allocate: it touched, and the jet met hidden elements.
    EXPECT_GT(state.flows.contact_impulse, 0.0);
    EXPECT_GT(state.jets.front().total.hidden, 0u);
  }
  const long before = support::allocations();
  { std::vector<double> control(10); }
  EXPECT_GT(support::allocations() - before, 0) << "the counter counts";
}

}  // namespace
