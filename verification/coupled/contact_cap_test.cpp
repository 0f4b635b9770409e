// SPDX-License-Identifier: Apache-2.0
// The stiffness of contact up to which a fixed step is allowed: the share of the bound that other terms
// leave. Where motion itself blows up is measured in coupling/contact_bound_test.cpp.
#include <gtest/gtest.h>

#include <string>

#include "bisection.hpp"
#include "claim.hpp"
#include "run_case.hpp"

namespace {

// Of a ball whose fabric and gas alone allow 34 us.
const std::string kStep = "24e-6";  // [s]

bool is_done(double share) {
  const auto run = coupled::run_case("ball_impact", {"time.step=" + kStep, "scene.end_time=0.006",
                                                     "contact.stiffness_share=" + std::to_string(share)});
  if (run.outcome.status == driver::RunStatus::done) return true;
  EXPECT_NE(run.outcome.message.find("above its bound"), std::string::npos) << run.outcome.message;
  return false;
}

TEST(contact_cap, largest_share_at_a_fixed_step_eq_what_other_terms_leave) {
  const auto scene = coupled::scene_of("ball_impact");
  driver::State state = driver::make_state(scene);
  driver::StepRecords records;
  driver::step(scene, state, {}, records);
  const double step = std::stod(kStep);
  // omega^2 of all points in touch is in proportion to the share, which is 1 here.
  const double left = (4.0 / (step * step) - state.step.shares.total()) / scene.contact->full_omega_squared();
  const double allowed = claim::largest_passing(0.3, 3.0, 0.01, is_done);
  claim::expect_threshold(
      {"K.12", "struck ball, fixed step of 24 us",
       "terms of the start: the ball breathes by 7 % of omega^2, pendulum and turning ask for some more"},
      {"contact stiffness at a fixed step", "share ≤ (4/Δt² − other ω²)/ω_contact²", left, allowed, "-",
       "exit 3 before it touches, naming the shares"},
      0.85, 1.0);
}

}  // namespace
