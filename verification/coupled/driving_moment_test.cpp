// SPDX-License-Identifier: Apache-2.0
// A moment that a case prescribes on its pendulum, against closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "claim.hpp"
#include "closed_form/pendulum.hpp"
#include "run_case.hpp"

namespace {

constexpr double kDuration = 0.02, kLater = 0.05;  // [s]

// A half-sine of 2000 pieces, whose polygon is off by 2e-7 of its impulse.
std::string half_sine(double peak) {
  std::string times, values;
  for (int i = 0; i <= 2000; ++i) {
    times += fmt::format("{}{}", i > 0 ? "," : "", kDuration * i / 2000);
    values += fmt::format("{}{}", i > 0 ? "," : "", i < 2000 ? peak * std::sin(M_PI * i / 2000) : 0.0);
  }
  return "pendulum.driving_moment={time=[" + times + "],value=[" + values + "]}";
}

coupled::CaseRun pulse(double peak, double step, const char* gravity) {
  return coupled::run_case("pendulum_pulse", {half_sine(peak), fmt::format("time.step={}", step),
                                              std::string("scene.gravity=") + gravity});
}

const double kInertia = closed_form::pendulum_constants(closed_form::paper_pendulum()).axis_inertia;

TEST(driving_moment, free_pendulum_turns_as_the_pulse_integrated_twice) {
  const double rate = M_PI / kDuration, peak = 655.0;
  // After the pulse: M0/I (T/w) within it, then 2 M0/(I w) for the rest.
  const double exact = peak / kInertia / rate * (kDuration + 2.0 * (kLater - kDuration));
  for (const double step : {2e-3, 1e-3, 5e-4}) {
    const auto run = pulse(peak, step, "[0,0,0]");
    claim::expect_relative({"K.4", "half-sine moment on a free pendulum: angle at 50 ms, steps 0.5 to 2 ms",
                            "polygon 2e-7; a symmetric pulse has no error of the step"},
                           run.history.back().at("pendulum_angle_rad"), exact, 3e-7);
    // A free pendulum keeps (K.21) at every level: (K.42). Rounding of some 20 J.
    EXPECT_LT(run.state.peaks.energy_residual, 1e-12);
    EXPECT_NEAR(run.energy.back().at("driving_work_J"), run.energy.back().at("pendulum_kinetic_J"), 1e-12);
    EXPECT_LT(std::abs(run.energy.back().at("kick_residual_J")), 1e-12);
  }
}

TEST(driving_moment, pulse_within_a_step_has_its_impulse) {
  const auto run =
      coupled::run_case("pendulum_pulse", {"pendulum.driving_moment={time=[0.00101,0.00103],value=[5e5,5e5]}",
                                           "time.step=3e-3", "scene.gravity=[0,0,0]"});
  EXPECT_NEAR(run.history.back().at("pendulum_angular_velocity_rad_s"), 10.0 / kInertia, 1e-12);
  EXPECT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  EXPECT_LT(run.state.peaks.energy_residual, 1e-12);
}

// Without gravity the joint alone carries m a, and turns with M/I.
TEST(driving_moment, outside_of_the_run_has_a_warning) {
  const auto warnings = [](const char* times) {
    return coupled::scene_of("pendulum_pulse",
                             {fmt::format("pendulum.driving_moment={{time={},value=[1,1]}}", times)})
        .warnings.size();
  };
  EXPECT_EQ(warnings("[0.05,0.06]"), 1U);  // the run ends at 0.05
  EXPECT_EQ(warnings("[0.0,0.06]"), 0U);
}

TEST(driving_moment, joint_and_acceleration_feel_it) {
  const auto run = coupled::run_case(
      "pendulum_pulse", {"pendulum.driving_moment=100", "time.step=1e-4", "scene.gravity=[0,0,0]"});
  const auto& row = run.history.back();
  EXPECT_NEAR(row.at("pendulum_cg_tangential_m_s2"), 100.0 / kInertia * 1.065, 1e-9);
  EXPECT_NEAR(row.at("pendulum_angular_velocity_rad_s"), 100.0 / kInertia * kLater, 1e-9);
  EXPECT_NEAR(row.at("pendulum_joint_force_N"), 10.9 * row.at("pendulum_cg_acceleration_m_s2"), 1e-9);
}

TEST(driving_moment, hanging_pendulum_eq_the_linear_response) {
  const double force = 5.0;  // [N]: the angle stays below 6e-4, its square over 6 is 6e-8
  const auto pendulum = closed_form::paper_pendulum();
  const auto run = pulse(force * pendulum.impactor_arm, 1e-5, "[0,0,-9.80665]");
  const auto exact = closed_form::half_sine_response(pendulum, force, kDuration, kLater);
  claim::expect_relative({"K.1", "half-sine moment on the hanging pendulum: angle at 50 ms",
                          "polygon 2e-7, step (w dt)^2/12 = 2e-7, sine of the angle 6e-8"},
                         run.history.back().at("pendulum_angle_rad"), exact.angle, 1e-6);
}

TEST(driving_moment, shipped_case_is_near_the_closed_form_that_it_names) {
  const auto run = coupled::run_case("pendulum_pulse");
  const auto exact = closed_form::half_sine_response(closed_form::paper_pendulum(), 500.0, kDuration, kLater);
  EXPECT_NEAR(run.history.back().at("pendulum_angle_rad") / exact.angle, 1.0, 3e-3);
}

}  // namespace
