// SPDX-License-Identifier: Apache-2.0
// Motion of the rigid pendulum by central difference against elliptic functions: order, period, pulse, books.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "bisection.hpp"
#include "claim.hpp"
#include "closed_form/pendulum.hpp"
#include "scenes.hpp"

namespace {

using coupling::PendulumModel;
using coupling::PendulumState;

constexpr double kDegree = std::numbers::pi / 180.0;

// Steps of one size with gravity and a horizontal force at the impactor that may depend on time. `state`
// starts with the velocity of t = 0 and ends at level `steps`; returns the velocity of that level.
template <class Force>
double march(const PendulumModel& model, PendulumState& state, double dt, int steps, Force force) {
  double before = 0.0;
  for (int n = 0; n <= steps; ++n) {
    const Eigen::Vector3d push(force(n * dt), 0.0, 0.0);
    const double moment =
        model.gravity_moment(state.angle) + model.moment(push, model.impactor_centre(state.angle));
    if (n == steps) return model.angular_velocity_at_level(state, moment, before);
    state = model.advance(state, moment, 0.5 * (before + dt), dt);
    before = dt;
  }
  return 0.0;
}

double no_force(double) {
  return 0.0;
}

// Released at `amplitude`, started a third of a period later so that angle and velocity are both non-zero.
double swing_error(double amplitude, double duration, int steps) {
  const auto exact = closed_form::paper_pendulum();
  const PendulumModel model(scenes::paper_pendulum());
  const double start = closed_form::pendulum_period(exact, amplitude) / 3.0;
  const auto first = closed_form::pendulum_swing(exact, amplitude, start);
  const auto last = closed_form::pendulum_swing(exact, amplitude, start + duration);
  PendulumState state{first.angle, first.angular_velocity};
  const double velocity = march(model, state, duration / steps, steps, no_force);
  return std::hypot(state.angle - last.angle, (velocity - last.angular_velocity) / 2.8);
}

std::string whole(double degrees) {
  std::ostringstream text;
  text << degrees;
  return text.str();
}

TEST(PendulumMotion, swing_converges_at_order_2_to_jacobi) {
  for (const double degrees : {1.0, 30.0, 60.0, 90.0, 170.0}) {
    std::vector<double> errors;
    for (const int steps : {400, 800, 1600}) errors.push_back(swing_error(degrees * kDegree, 1.7, steps));
    claim::expect_order(
        {"K.4", "swing from " + whole(degrees) + " degrees, Jacobi's functions: angle and velocity at 1.7 s",
         "the dt^4 term's share"},
        errors, 1.9, 2.1);
  }
}

// Where the cubic through values at -1, 0, 1, 2 crosses zero between 0 and 1.
double cubic_crossing(const double (&y)[4]) {
  double s = y[1] / (y[1] - y[2]);
  for (int i = 0; i < 20; ++i) {  // chord method, from the straight line's crossing
    const double a = -s * (s - 1.0) * (s - 2.0) / 6.0, b = (s + 1.0) * (s - 1.0) * (s - 2.0) / 2.0,
                 c = -(s + 1.0) * s * (s - 2.0) / 2.0, d = (s + 1.0) * s * (s - 1.0) / 6.0;
    s -= (a * y[0] + b * y[1] + c * y[2] + d * y[3]) / (y[2] - y[1]);
  }
  return s;
}

// Period from four quarter swings: the crossing of angle 0, by the cubic through four levels, whose error is
// of fourth order in dt and leaves the method's second order alone.
double measured_quarter(double amplitude, double dt) {
  const PendulumModel model(scenes::paper_pendulum());
  PendulumState state{amplitude, 0.0};
  double before = 0.0, last[4] = {amplitude, amplitude, amplitude, amplitude};
  for (int n = 1;; ++n) {
    state = model.advance(state, model.gravity_moment(state.angle), 0.5 * (before + dt), dt);
    before = dt;
    for (int i = 0; i < 3; ++i) last[i] = last[i + 1];
    last[3] = state.angle;
    if (last[2] <= 0.0) return (n - 2 + cubic_crossing(last)) * dt;
  }
}

TEST(PendulumMotion, period_converges_at_order_2) {
  for (const double degrees : {0.5, 30.0, 60.0, 90.0, 170.0}) {
    const double exact = closed_form::pendulum_period(closed_form::paper_pendulum(), degrees * kDegree);
    std::vector<double> errors;
    for (int level = 0; level < 4; ++level)
      errors.push_back(std::abs(4.0 * measured_quarter(degrees * kDegree, 0.02 / (1 << level)) - exact));
    claim::expect_order({"K.4", "swing from " + whole(degrees) + " degrees: period [s]",
                         "the dt^4 term's share, that of the crossing too"},
                        errors, 1.95, 2.05);
    EXPECT_LT(errors.back() / exact, 2e-5) << degrees;  // (omega0 dt)^2/24 = 2e-6, more at 170 degrees
  }
}

TEST(PendulumMotion, period_of_small_swing_eq_2pi_over_omega) {
  const auto constants = closed_form::pendulum_constants(closed_form::paper_pendulum());
  const double dt = 1e-3, w = constants.angular_frequency * dt;
  // Central difference shortens the period by asin(w/2)/(w/2), amplitude lengthens it by a^2/16 = 6e-12.
  const double expected = constants.small_swing_period * (w / 2.0) / std::asin(w / 2.0);
  claim::expect_relative(
      {"K.4", "small swing, discrete: period [s]", "the crossing's cubic is off by (omega0 dt)^4"},
      4.0 * measured_quarter(1e-5, dt), expected, 1e-9);
}

TEST(PendulumMotion, impulse_eq_closed_form) {
  const auto exact = closed_form::pendulum_impulse(closed_form::paper_pendulum(), 20.0);
  const PendulumModel model(scenes::paper_pendulum());
  // A force over one step of 1 us: the blow's own duration moves the velocity by (omega0 dt)^2, 1e-11.
  const double dt = 1e-6;
  PendulumState state;
  const double moment = model.moment({20.0 / dt, 0.0, 0.0}, model.impactor_centre(0.0));
  state = model.advance(state, moment, dt, dt);
  const char* why = "the blow's own duration, (omega0 dt)^2 of the velocity, does not act yet: rounding";
  claim::expect_relative({"K.1", "blow of 20 N s: angular velocity [rad/s]", why}, state.angular_velocity,
                         exact.angular_velocity, 1e-12);
  claim::expect_relative({"K.7", "blow of 20 N s: kinetic energy [J]", why},
                         model.kinetic_energy(state.angular_velocity), exact.kinetic_energy, 1e-12);
  const int steps = 20000;
  PendulumState swing{0.0, state.angular_velocity};
  const double velocity = march(model, swing, exact.time_of_maximum / steps, steps, no_force);
  claim::expect_near(
      {"K.7", "blow of 20 N s: largest angle [rad]", "order 2: (omega0 dt)^2 / 24 = 3e-10 of it"},
      swing.angle, exact.maximum_angle, 1e-8);
  EXPECT_NEAR(velocity, 0.0, 1e-8);
}

TEST(PendulumMotion, half_sine_pulse_converges_at_order_2) {
  const auto exact = closed_form::paper_pendulum();
  const PendulumModel model(scenes::paper_pendulum());
  // 1e-3 N: the angle stays below 1e-4 rad, its sine is linear to 2e-9; errors below are 1e-3 and more of it.
  const double force = 1e-3, pulse = 0.3, end = 0.6;
  const auto last = closed_form::half_sine_response(exact, force, pulse, end);
  std::vector<double> errors;
  for (int level = 0; level < 3; ++level) {
    const int steps = 20 << level;
    PendulumState state;
    march(model, state, end / steps, steps,
          [&](double t) { return t < pulse ? force * std::sin(std::numbers::pi * t / pulse) : 0.0; });
    errors.push_back(std::abs(state.angle - last.angle) / std::abs(last.angle));
  }
  claim::expect_order(
      {"K.4", "half-sine push on the pendulum: angle", "the dt^4 term's share; linear to 2e-9"}, errors, 1.9,
      2.1);
  EXPECT_GT(errors.back(), 1e-6);  // far above what linearising leaves out
}

TEST(PendulumMotion, constant_force_reaches_closed_form_angle) {
  const PendulumModel model(scenes::paper_pendulum());
  const double exact = closed_form::constant_force_maximum_angle(closed_form::paper_pendulum(), 100.0);
  PendulumState state;
  double before = 0.0, largest = 0.0;
  const double dt = 1e-4;
  for (int n = 0; n < 20000; ++n) {
    const double moment = model.gravity_moment(state.angle) +
                          model.moment({100.0, 0.0, 0.0}, model.impactor_centre(state.angle));
    state = model.advance(state, moment, 0.5 * (before + dt), dt);
    before = dt;
    largest = std::max(largest, state.angle);
  }
  claim::expect_near({"K.7", "constant force of 100 N: largest angle [rad]",
                      "sampled maximum, alpha dt^2 / 8 = 1e-8, and order 2, 1e-8"},
                     largest, exact, 1e-7);
}

TEST(PendulumMotion, kick_form_closes_for_varying_steps) {
  const PendulumModel model(scenes::paper_pendulum());
  PendulumState state{0.7, -1.0};
  double before = 0.0, work = 0.0, supplied = 0.0;
  const double start = model.kinetic_energy(state.angular_velocity);
  for (int n = 0; n < 5000; ++n) {
    const double dt = 1e-3 * (1.5 + std::sin(0.37 * n)), tau = 0.5 * (before + dt);
    const double moment = model.gravity_moment(state.angle) + 50.0 * std::sin(0.01 * n);
    const PendulumState next = model.advance(state, moment, tau, dt);
    const double kick = tau * moment * 0.5 * (state.angular_velocity + next.angular_velocity);
    work += kick;
    supplied += std::abs(kick);
    state = next;
    before = dt;
  }
  claim::expect_near({"K.20", "pendulum, varying steps: kinetic energy gained, work of the kicks [J]",
                      "5000 sums of two roundings of all the work"},
                     model.kinetic_energy(state.angular_velocity) - start, work, 1e-12 * supplied);
}

TEST(PendulumMotion, step_limit_eq_2_over_omega) {
  const PendulumModel model(scenes::paper_pendulum());
  const double limit = 2.0 / std::sqrt(model.omega_squared(Eigen::Vector3d::Zero()));
  EXPECT_NEAR(limit, 0.71213232672975937, 1e-13);  // 2 / omega0
  const auto bounded = [&](double dt) {
    PendulumState state{1e-12, 0.0};
    double largest = 0.0;
    for (int n = 0; n < 200; ++n) {
      state = model.advance(state, model.gravity_moment(state.angle), dt, dt);
      largest = std::max(largest, std::abs(state.angle));
    }
    // A thousandth past the limit growth is 1.065 a step; the beat below it is 1/sqrt(1 - 0.999^2) = 22.
    return largest < 1e-10;
  };
  claim::expect_threshold(
      {"K.8", "the paper's pendulum", "bisection to 2e-4; a thousandth decides within 200 steps"},
      {"pendulum under gravity", "Δt = 2/ω_rot", limit,
       claim::largest_passing(0.5 * limit, 2.0 * limit, 2e-4, bounded), "s",
       "a share of the bound: Δt follows; a fixed step: exit 3"},
      1.0 - 1e-3, 1.0 + 1e-3);
}

}  // namespace
