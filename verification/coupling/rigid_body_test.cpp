// SPDX-License-Identifier: Apache-2.0
// A rigid body on a rail and a free one by central difference: closed forms, order, balances.
#include "coupling/rigid_body.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "claim.hpp"

namespace {

using coupling::RigidBodyModel, coupling::RigidBodyParameters, coupling::RigidBodyState;
using Eigen::Vector3d;

RigidBodyParameters on_rail(double velocity, std::vector<coupling::RailSpring> springs) {
  RigidBodyParameters p;
  p.mass = 6.8;  // [kg] of a headform, with what carries it
  p.centre = {0.4, 0.1, -0.2};
  p.rail = coupling::Rail{{-2.0, 0.0, 0.0}, std::move(springs)};
  p.velocity = {-velocity, 0.0, 0.0};
  return p;
}

struct End {
  RigidBodyState state;
  double work = 0.0, damping_loss = 0.0, speed = 0.0;  // [m/s] at the end's level
};

// Steps of one size under a constant force along x [N].
End march(const RigidBodyModel& model, double duration, int steps, double force = 0.0) {
  End end{model.initial()};
  const double dt = duration / steps;
  double before = 0.0;
  for (int n = 0; n < steps; ++n) {
    const auto kick =
        model.advance(end.state, {{force, 0.0, 0.0}, Vector3d::Zero()}, 0.5 * (before + dt), dt);
    end.work += kick.work;
    end.damping_loss += kick.damping_loss;
    before = dt;
  }
  RigidBodyState last = end.state;
  const auto kick = model.advance(last, {{force, 0.0, 0.0}, Vector3d::Zero()}, 0.5 * dt, 0.0);
  end.work += kick.work;
  end.damping_loss += kick.damping_loss;
  end.speed = model.speed(last.velocity);
  return end;
}

TEST(RigidBody, guided_mass_stops_under_a_constant_force_within_half_m_v2_over_F) {
  const double v = 9.0, force = 2500.0;  // against the motion, which goes along -x
  const RigidBodyModel model(on_rail(v, {}));
  const double mass = model.parameters().mass, stop = mass * v / force;
  const End end = march(model, stop, 400, force);
  claim::expect_relative(
      {"K.55", "guided mass under a constant force: way to the stop, m v^2 / 2 F [m]", "exact"},
      model.displacement(end.state), 0.5 * mass * v * v / force, 1e-13);
  EXPECT_NEAR(end.speed, 0.0, 1e-12);
  EXPECT_NEAR(end.work, -0.5 * mass * v * v, 1e-10);
  EXPECT_EQ(end.state.centre[1], 0.1);
}

TEST(RigidBody, guided_mass_with_spring_and_damper_follows_its_closed_form_at_order_2) {
  const double v = 5.0, k = 30e3, c = 120.0, duration = 0.04;
  const RigidBodyModel model(on_rail(v, {{k, c, 0.0, false}}));
  const double mass = model.parameters().mass, delta = 0.5 * c / mass,
               omega = std::sqrt(k / mass - delta * delta);
  const double exact = v / omega * std::exp(-delta * duration) * std::sin(omega * duration);
  std::vector<double> error;
  for (const int steps : {100, 200, 400, 800}) {
    const End end = march(model, duration, steps);
    error.push_back(model.displacement(end.state) / exact - 1.0);
    const double energy = 0.5 * mass * end.speed * end.speed + model.spring_energy(end.state);
    EXPECT_NEAR((energy + end.damping_loss) / (0.5 * mass * v * v) - 1.0, 0.0, 30.0 / (steps * steps))
        << steps;
  }
  claim::expect_order({"K.55", "guided mass with spring and damper: displacement over its closed form less 1",
                       "central difference; the damper follows the mean of both speeds"},
                      error, 1.9, 2.1);
}

TEST(RigidBody, stop_throws_the_mass_back_with_its_speed_after_half_a_period) {
  const double v = 3.0, k = 1e6, at = 0.05;
  const RigidBodyModel model(on_rail(v, {{k, 0.0, at, true}}));
  const double half = std::numbers::pi * std::sqrt(model.parameters().mass / k);
  const End end = march(model, 2.0 * at / v + half, 20000);
  claim::expect_relative({"K.55", "mass against an elastic stop: speed when it is back at the start [m/s]",
                          "the force's kink at the stop"},
                         end.speed, -v, 1e-4);
  EXPECT_NEAR(model.displacement(end.state), 0.0, 1e-4 * at);
}

RigidBodyParameters tumbling() {
  RigidBodyParameters p;
  p.mass = 4.5;
  p.velocity = {3.0, 0.0, 4.0};
  p.gravity = {0.0, 0.0, -9.80665};
  // Principal moments 0.016, 0.021, 0.026 kg m2 in axes of its own.
  const Eigen::Matrix3d own =
      Eigen::AngleAxisd(0.7, Vector3d(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  p.inertia = own * Vector3d(0.016, 0.021, 0.026).asDiagonal() * own.transpose();
  p.axes = Eigen::AngleAxisd(-0.4, Vector3d::UnitY()).toRotationMatrix();
  p.angular_velocity = p.axes * own * Vector3d(20.0, 0.0, 30.0);  // [rad/s]
  return p;
}

// L. D. Landau, E. M. Lifshitz, Mechanics, section 37: rotation that starts without a component about the
// middle axis.
Vector3d euler_top(const Vector3d& i, double first, double third, double t) {
  const double energy2 = i[0] * first * first + i[2] * third * third;
  const double momentum2 = std::pow(i[0] * first, 2) + std::pow(i[2] * third, 2);
  const double slow = energy2 * i[2] - momentum2, fast = momentum2 - energy2 * i[0];
  const double rate = std::sqrt((i[2] - i[1]) * fast / (i[0] * i[1] * i[2]));
  const double k = std::sqrt((i[1] - i[0]) * slow / ((i[2] - i[1]) * fast));
  double cn, dn;
  const double sn = boost::math::jacobi_elliptic(k, rate * t, &cn, &dn);
  return {first * cn, std::sqrt(slow / (i[1] * (i[2] - i[1]))) * sn, third * dn};
}

TEST(RigidBody, free_body_tumbles_as_eulers_top_at_order_2) {
  const RigidBodyParameters p = tumbling();
  const RigidBodyModel model(p);
  const double duration = 0.3;
  const Vector3d moments(0.016, 0.021, 0.026), exact = euler_top(moments, 20.0, 30.0, duration);
  const Eigen::Matrix3d own =
      Eigen::AngleAxisd(0.7, Vector3d(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  std::vector<double> error, energy;
  for (const int steps : {150, 300, 600, 1200}) {
    const End end = march(model, duration, steps);
    const Vector3d spin = own.transpose() * (end.state.axes.transpose() * model.angular_velocity(end.state));
    // Signs of the middle component belong to the axes' handedness.
    error.push_back((spin.cwiseAbs() - exact.cwiseAbs()).norm() / exact.norm());
    energy.push_back(moments.cwiseProduct(spin.cwiseAbs2()).sum() /
                         moments.cwiseProduct(Vector3d(20.0, 0.0, 30.0).cwiseAbs2()).sum() -
                     1.0);
    const RigidBodyState start = model.initial();
    EXPECT_LT((end.state.angular_momentum - start.angular_momentum).norm(),
              1e-15 * start.angular_momentum.norm());
    EXPECT_LT((end.state.axes.transpose() * end.state.axes - Eigen::Matrix3d::Identity()).norm(), 1e-14);
  }
  claim::expect_order(
      {"K.56", "tumbling body: angular velocity against Euler's top", "splitting about the axes"}, error, 1.8,
      2.2);
  claim::expect_order({"K.56", "tumbling body: kinetic energy of rotation, over that at the start, less 1",
                       "splitting about the axes"},
                      energy, 1.8, 2.2);
}

TEST(RigidBody, energy_of_a_tumbling_body_stays_for_a_million_steps) {
  const RigidBodyModel model(tumbling());
  RigidBodyState state = model.initial();
  const double dt = 5e-4, start = state.angular_momentum.dot(model.angular_velocity(state));
  double largest = 0.0;
  for (int n = 0; n < 1000000; ++n) {
    model.advance(state, {}, dt, dt);
    largest =
        std::max(largest, std::abs(state.angular_momentum.dot(model.angular_velocity(state)) / start - 1.0));
  }
  claim::expect_near(
      {"K.56", "tumbling body: largest change of energy in 1e6 steps of 1/60 rad", "bounded by order dt^2"},
      largest, 0.0, 1e-4);
}

TEST(RigidBody, free_body_falls_on_its_parabola_and_turns_under_a_couple) {
  const RigidBodyParameters p = tumbling();
  const RigidBodyModel model(p);
  const double t = 0.2, force = 50.0;
  const End end = march(model, t, 100, force);
  const Vector3d exact = p.velocity * t + 0.5 * t * t * (p.gravity + Vector3d(force / p.mass, 0.0, 0.0));
  claim::expect_relative(
      {"K.55", "free body in a uniform field and under a constant force: way [m]", "exact"},
      model.displacement(end.state), exact.norm(), 1e-13);
  // Angular momentum is the sum of the couples.
  RigidBodyState state = model.initial();
  const Vector3d couple(0.1, -0.2, 0.3), start = state.angular_momentum;
  double work = 0.0, rotation = 0.0;
  for (int n = 0; n < 50; ++n) {
    const auto kick = model.advance(state, {Vector3d::Zero(), couple}, 1e-3, 1e-3);
    work += kick.load_work;
    EXPECT_NEAR(kick.kinetic_after - kick.kinetic_before, kick.work, 1e-12);
    rotation = state.angular_momentum.dot(model.angular_velocity(state));
  }
  EXPECT_LT((state.angular_momentum - start - 0.05 * couple).norm(), 1e-14);
  EXPECT_GT(std::abs(work), 0.0);
  EXPECT_GT(rotation, 0.0);
}

void expect_refused(const RigidBodyParameters& p, const std::string& says) {
  try {
    RigidBodyModel{p};
    ADD_FAILURE() << says;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
  }
}

TEST(RigidBody, what_is_no_body_is_named) {
  RigidBodyParameters p = tumbling();
  p.mass = 0.0;
  expect_refused(p, "body.mass = 0");
  p = tumbling();
  p.inertia = Vector3d(1.0, 1.0, 3.0).asDiagonal();
  expect_refused(p, "body.inertia");
  p.inertia = Vector3d(1.0, 1.0, -1.0).asDiagonal();
  expect_refused(p, "positive definite");
  p.inertia(0, 1) = 0.5;
  expect_refused(p, "symmetric");
  p = tumbling();
  p.axes(0, 0) += 0.1;
  expect_refused(p, "body.axes");
  p = on_rail(1.0, {});
  p.rail->direction.setZero();
  expect_refused(p, "rail.direction");
  p = on_rail(1.0, {{-1.0, 0.0, 0.0, false}});
  expect_refused(p, "rail.spring.stiffness = -1");
  p = on_rail(1.0, {{1.0, -1.0, 0.0, true}});
  expect_refused(p, "rail.stop.damping = -1");
  p = on_rail(1.0, {});
  p.velocity = {1.0, 1.0, 0.0};
  expect_refused(p, "body.velocity");
  p = on_rail(1.0, {});
  p.angular_velocity = {1.0, 0.0, 0.0};
  expect_refused(p, "body.angular_velocity");
}

}  // namespace
