// SPDX-License-Identifier: Apache-2.0
// The stiffness of contact up to which a fixed step is allowed, by bisection, against the formula.
#include <gtest/gtest.h>

#include <cmath>

#include "claim.hpp"
#include "run_case.hpp"

namespace {

// Of a ball whose fabric and gas alone allow 34 us.
constexpr double kStep = 24e-6;  // [s]

bool is_done(double share) {
  const auto run = coupled::run_case("ball_impact", {"time.step=24e-6", "scene.end_time=0.006",
                                                     "contact.stiffness_share=" + std::to_string(share)});
  if (run.outcome.status == driver::RunStatus::done) return true;
  EXPECT_NE(run.outcome.message.find("above its bound"), std::string::npos) << run.outcome.message;
  return false;
}

// Largest share that is done, to 1 %.
double largest_done(double done, double refused) {
  EXPECT_TRUE(is_done(done));
  EXPECT_FALSE(is_done(refused));
  while (refused > 1.01 * done) {
    const double middle = std::sqrt(done * refused);
    (is_done(middle) ? done : refused) = middle;
  }
  return done;
}

TEST(contact_cap, largest_share_at_a_fixed_step_eq_what_other_terms_leave) {
  const auto scene = coupled::scene_of("ball_impact");
  driver::State state = driver::make_state(scene);
  driver::StepRecords records;
  driver::step(scene, state, {}, records);
  // omega^2 of all points in touch is in proportion to the share, which is 1 here.
  const double predicted =
      (4.0 / (kStep * kStep) - state.step.shares.total()) / scene.contact->full_omega_squared();
  // The other terms are those at the start: the ball breathes before it is struck, by 7 % of their omega^2,
  // which is 7 % of the share too, and pendulum and turning of the force ask for some percent.
  claim::expect_threshold({"K.12", "ball impact at a step of 24 us, stiffness as a share of the fabric's",
                           "the other terms come and go by 7 %, the pendulum's adds some percent"},
                          {"stiffness of contact at a fixed step", "what the other terms leave of 4 / dt^2",
                           predicted, largest_done(0.3, 3.0), "-", "exit 3 before it touches"},
                          0.85, 1.0);
}

}  // namespace
