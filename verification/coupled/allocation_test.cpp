// SPDX-License-Identifier: Apache-2.0
// No allocation inside a step.
#include <gtest/gtest.h>

#include "run_case.hpp"
#include "support/allocation_counter.hpp"

namespace {

long allocations_of_steps(const driver::Scene& scene, int warm_up, int steps) {
  driver::State state = driver::make_state(scene);
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
  // 300 steps reach contact with the pendulum; the first step may still fill the workspace of the search.
  for (const char* name : {"passenger_pendulum", "passenger_pendulum_no_jet", "sphere_inflation",
                           "tank_blowdown", "plate_jet"}) {
    const auto scene = coupled::scene_of(name);
    EXPECT_EQ(allocations_of_steps(scene, 1, 300), 0) << name;
  }
  const long before = support::allocations();
  { std::vector<double> control(10); }
  EXPECT_GT(support::allocations() - before, 0) << "the counter counts";
}

}  // namespace
