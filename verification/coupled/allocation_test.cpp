// SPDX-License-Identifier: Apache-2.0
// No allocation inside a step.
#include <gtest/gtest.h>

#include "run_case.hpp"
#include "support/allocation_counter.hpp"

namespace {

long allocations_of_steps(const driver::Scene& scene, driver::State& state, int warm_up, int steps) {
  const auto advance = [&](int count) {
    for (int i = 0; i < count && state.time < scene.time.end; ++i) {
      driver::step(scene, state, {});
      state.time += state.step.after;
      ++state.steps;
    }
  };
  advance(warm_up);
  const long before = support::allocations();
  advance(steps);
  return support::allocations() - before;
}

// Steps, at most to the scene's end, so many that each scene does what could allocate: every gas method,
// triggers, backflow, walls, fabric tables, jets that take from the gas, woven fabric.
const std::pair<const char*, int> kScenes[] = {
    {"passenger_pendulum", 300}, {"passenger_pendulum_no_jet", 100},
    {"ball_impact", 100},        {"sphere_inflation", 100},
    {"tank_blowdown", 300},      {"tank_stiff", 18},
    {"tank_triggers", 300},      {"tank_backflow", 200},
    {"tank_fixed_steps", 4},     {"piston_leak", 100},
    {"bag_volume", 60},          {"contact_vent", 300},
    {"bag_leak_table", 50},      {"jet_bag", 50},
    {"driver_bag", 30},          {"plate_jet", 50}};

TEST(allocation, none_inside_a_step) {
  for (const auto& [name, steps] : kScenes) {
    auto scene = coupled::scene_of(name);
    scene.output.streams = scene.has_volume();
    driver::State state = driver::make_state(scene);
    // The first step may still fill the workspace of the contact search.
    EXPECT_EQ(allocations_of_steps(scene, state, 1, steps), 0) << name;
    const bool main_scene = std::string(name) == "passenger_pendulum";
    if (main_scene || std::string(name) == "contact_vent") {
      EXPECT_GT(state.flows.contact_impulse, 0.0) << name;
    }
    if (main_scene) {
      EXPECT_GT(state.jets.front().total.hidden, 0u);
    }
  }
  const long before = support::allocations();
  { std::vector<double> control(10); }
  EXPECT_GT(support::allocations() - before, 0) << "the counter counts";
}

}  // namespace
