// SPDX-License-Identifier: Apache-2.0
// Where contact ends, in a whole run: exit code 3 with stage, time and limit, and the threshold beside it.
#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "bisection.hpp"
#include "claim.hpp"
#include "run_case.hpp"

namespace {

using coupled::run_case;

TEST(contact_limits, stiffness_past_the_cap_of_a_fixed_step_is_refused_before_it_touches) {
  // Fabric alone allows 34.3 us (this ball at rest, 3 % less when it breathes): 24 us leaves half of omega^2.
  const auto at = [](const char* share) {
    return run_case("ball_impact", {"time.step=24e-6", "scene.end_time=0.006",
                                    std::string("contact.stiffness_share=") + share});
  };
  const auto soft = at("0.3");
  EXPECT_EQ(soft.outcome.status, driver::RunStatus::done) << soft.outcome.message;
  EXPECT_GT(soft.state.flows.contact_impulse, 0.0);
  const auto stiff = at("3.0");
  ASSERT_EQ(stiff.outcome.status, driver::RunStatus::failed);
  for (const char* word : {"is unstable: the limit is", "contact 7", "stage S8_advance"})
    EXPECT_NE(stiff.outcome.message.find(word), std::string::npos) << stiff.outcome.message;
  // As soon as a step could bring it into touch, and not from the start.
  EXPECT_EQ(stiff.state.contact.area, 0.0);
  EXPECT_GT(stiff.state.time, 0.002);
  EXPECT_LT(stiff.state.time, soft.state.peaks.first_contact);
}

// The step falls before the skin touches: what stiffness asks of it is never found out by a blow-up.
TEST(contact_limits, any_stiffness_is_followed_by_the_step) {
  const auto at = [](const char* share) {
    return run_case("ball_impact", {"membrane.mesh.levels=2", "contact.friction=0.0", "scene.end_time=0.006",
                                    std::string("contact.stiffness_share=") + share});
  };
  for (const char* share : {"16.0", "256.0"}) {
    const auto run = at(share);
    ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
    EXPECT_GT(run.state.flows.contact_impulse, 0.1) << share;  // [N s]
    EXPECT_LT(run.state.peaks.energy_residual, 1e-3 * run.state.peaks.energy_scale) << share;
  }
  const auto stiff = at("1e15");
  ASSERT_EQ(stiff.outcome.status, driver::RunStatus::failed);
  for (const char* word :
       {"contact 100 %", "more than 1e9 steps of", "stage S8_advance", "lower contact.stiffness"})
    EXPECT_NE(stiff.outcome.message.find(word), std::string::npos) << stiff.outcome.message;
  EXPECT_EQ(stiff.state.flows.contact_impulse, 0.0);
}

TEST(contact_limits, soft_contact_ends_at_half_the_radius) {
  const auto at = [](const char* share) {
    return run_case("ball_impact", {"membrane.mesh.levels=2", "contact.friction=0.0",
                                    std::string("contact.stiffness_share=") + share});
  };
  const double half = 0.5 * 0.041;  // [m] of the case's impactor
  const auto soft = at("0.01");
  EXPECT_EQ(soft.outcome.status, driver::RunStatus::done) << soft.outcome.message;
  EXPECT_GT(soft.state.peaks.penetration, 0.5 * half);
  const auto softer = at("0.001");
  ASSERT_EQ(softer.outcome.status, driver::RunStatus::failed);
  for (const char* word : {"penetration", "element", "exceeds half the sphere's radius", "stage S4_contact",
                           "try contact.stiffness_share = 0.01, then 0.1 (now 0.001)"})
    EXPECT_NE(softer.outcome.message.find(word), std::string::npos) << softer.outcome.message;
  EXPECT_LE(softer.state.peaks.penetration, half);
}

// Up to the fastest that a step of 66 us follows, 236 rad/s (K.25).
TEST(contact_limits, sphere_that_strikes_at_full_speed_is_stopped_in_the_skin) {
  for (const char* speed : {"200.0", "220.0", "235.0"}) {
    const auto run = run_case("ball_impact", {std::string("pendulum.initial_angular_velocity=") + speed,
                                              "membrane.mesh.levels=2", "pendulum.pivot=[-0.2, 0.0, 1.31]"});
    ASSERT_EQ(run.outcome.status, driver::RunStatus::failed) << speed;
    EXPECT_NE(run.outcome.message.find("exceeds half the sphere's radius"), std::string::npos)
        << speed << run.outcome.message;
  }
}

// Turns through the ball in a step, a hundred of them too, are refused for what they are.
TEST(contact_limits, impactor_that_swings_farther_than_half_its_radius_in_a_step_is_refused) {
  constexpr double kInterval = 24e-6, kHalf = 0.5 * 0.041, kArm = 1.31;  // [s], [m]
  const auto at = [](double speed) {
    return run_case("ball_impact", {"time.step=24e-6", "scene.end_time=72e-6",
                                    "pendulum.initial_angular_velocity=" + std::to_string(speed),
                                    "membrane.mesh.levels=2", "pendulum.pivot=[-0.4, 0.0, 1.31]"});
  };
  const double fastest = claim::largest_passing(100.0, 1e4, 1e-6, [&](double speed) {
    const auto run = at(speed);
    if (run.outcome.status == driver::RunStatus::done) return true;
    for (const char* word : {"stage S4_contact at 2.4e-05 s", "the impactor swings", "0.0205 m"})
      EXPECT_NE(run.outcome.message.find(word), std::string::npos) << run.outcome.message;
    return false;
  });
  claim::expect_threshold(
      {"K.25", "the paper's pendulum, fixed step of 24 us, nothing near", "bisection to 1e-6"},
      {"impactor's swing in a step", "L_i Δt |dθ/dt| ≤ r/2", kHalf / (kArm * kInterval), fastest, "rad/s",
       "exit 3, naming the path in the step and the limit"},
      1.0 - 1e-6, 1.0 + 1e-6);
  for (const double speed : {9e4, 2.0 * std::numbers::pi / kInterval, 1e9})
    EXPECT_EQ(at(speed).outcome.status, driver::RunStatus::failed) << speed;
}

// Skin that is flung away at once: the search of its path ends.
TEST(contact_limits, skin_that_moves_a_thousand_radii_in_a_step_is_refused) {
  const auto run =
      run_case("passenger_sharp_no_jet", {"scene.gravity=[0.0, 0.0, -1e31]", "scene.end_time=2e-3"});
  ASSERT_EQ(run.outcome.status, driver::RunStatus::failed);
  for (const char* word : {"stage S4_contact", "past the sphere's centre within one step, the limit is 41 m"})
    EXPECT_NE(run.outcome.message.find(word), std::string::npos) << run.outcome.message;
}

TEST(contact_limits, sphere_that_starts_inside_or_in_the_skin_is_refused) {
  const auto at = [](const char* pivot) { return std::string("pendulum.pivot=[") + pivot + ", 0.0, 1.31]"; };
  EXPECT_NO_THROW(coupled::scene_of("ball_impact", {at("-0.1511")}));  // 0.1 mm off
  for (const char* pivot : {"-0.1500", "-0.1100", "0.0"}) {
    try {
      coupled::scene_of("ball_impact", {at(pivot)});
      ADD_FAILURE() << pivot << " accepted";
    } catch (const driver::CaseError& error) {
      EXPECT_NE(std::string(error.what()).find("impactor = "), std::string::npos) << error.what();
    }
  }
}

}  // namespace
