// SPDX-License-Identifier: Apache-2.0
// A jet that is there at once, at full strength, before a skin at rest.
#include <gtest/gtest.h>

#include <algorithm>

#include "bisection.hpp"
#include "claim.hpp"
#include "engine/step.hpp"
#include "run_case.hpp"

namespace {

// A small thin bag, soft enough that the jet sets the step, in a jet as wide as itself that starts at the
// third level.
struct Start {
  double bound = 0.0;                // [s] of the program, when the jet is there
  double before = 0.0, after = 0.0;  // [Pa] on the element of the greatest load then, and a step later
};

Start start(double dt) {
  const std::string step = std::to_string(dt * 1e9) + "e-9", fires = std::to_string(2.5e9 * dt) + "e-9";
  const auto scene = coupled::scene_of(
      "jet_bag", {"fabric.young_modulus=6e4", "fabric.thickness=5e-5", "inflator.0.mass_flow=8.0",
                  "inflator.0.jet.radius=0.08", "inflator.0.start_time=" + fires, "inflator.1.start_time=1.0",
                  "time.step=" + step, "time.unsafe_step=true"});
  driver::State state = driver::make_state(scene);
  Start result;
  std::size_t element = 0;
  const auto look = [&](const driver::State& now) {
    const auto& load = now.jets.front().load().overpressure;
    if (now.steps == 3) {
      element = static_cast<std::size_t>(std::max_element(load.begin(), load.end()) - load.begin());
      result.before = load[element];
    }
    if (now.steps == 4) result.after = load[element];
  };
  for (; state.steps < 5; ++state.steps) {
    driver::evaluate_level(scene, state, {});
    look(state);
    driver::advance_level(scene, state, {});
    if (state.steps == 3) result.bound = state.step.critical;
    state.time += state.step.after;
  }
  return result;
}

TEST(jet_from_rest, skin_outruns_the_jet_past_the_step_of_its_damping) {
  const Start at_rest = start(1e-6);
  ASSERT_GT(at_rest.before, 1e5);  // [Pa]
  const double measured = claim::largest_passing(0.5 * at_rest.bound, 2.0 * at_rest.bound, 1e-3,
                                                 [](double dt) { return start(dt).after > 0.0; });
  // A free skin at rest takes the jet's speed in one step of 2/c. Nodes average the load of their elements,
  // some of them farther off the axis, and the bound has the gas and the fabric in it: both let the skin have
  // a little more.
  claim::expect_threshold(
      {"J.9", "thin bag, wide jet, full flow at once; bound at rest",
       "nodes average loads; gas and fabric in the bound"},
      {"jet at full strength from rest", "ω²Δt² + 2 c Δt = 4, c = 2(1 + e) ρ₀ V A_e/m_e", at_rest.bound,
       measured, "s",
       "past it the skin is faster than the jet and its load goes out; the bound forbids that"},
      1.0, 1.25);
}

}  // namespace
