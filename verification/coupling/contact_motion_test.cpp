// SPDX-License-Identifier: Apache-2.0
// Motion under contact by central difference: a sphere bounces on free or sprung nodes. Momenta to round-off,
// (K.20) for varying steps, physical energy at second order, with a free sphere and with the pendulum.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "claim.hpp"
#include "scenes.hpp"

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

using scenes::kRadius;

constexpr double kSoft = 1e7;              // [N/m3]
constexpr double kSpring = 300.0 * 300.0;  // [1/s2] of every node to its place, over its mass

// A skin that moves and is sprung from the start.
struct MovingSkin {
  scenes::Skin skin = scenes::plate(8, 0.5 * kRadius, 3.0);
  Matrix3Xd place = skin.nodes;  // [m]
  Matrix3Xd velocity;            // [m/s] at n - 1/2
  double spring = kSpring;

  MovingSkin() {
    scenes::Skin shaken = skin;
    scenes::shake(shaken, 1.0, 3);
    velocity = 0.5 * (shaken.nodes - skin.nodes);
    scenes::shake(skin, 1e-3, 4);
  }
  double mass(Eigen::Index a) const { return skin.masses[static_cast<std::size_t>(a)]; }
  Eigen::RowVectorXd masses() const {
    return Eigen::Map<const Eigen::RowVectorXd>(skin.masses.data(), velocity.cols());
  }
  void add_springs(Matrix3Xd& f) const {
    for (Eigen::Index a = 0; a < f.cols(); ++a)
      f.col(a) -= mass(a) * spring * (skin.nodes.col(a) - place.col(a));
  }
  double spring_energy() const {
    return 0.5 * spring * masses().dot((skin.nodes - place).colwise().squaredNorm());
  }
  double kinetic(const Matrix3Xd& v) const { return 0.5 * masses().dot(v.colwise().squaredNorm()); }
  Matrix3Xd kicked(const Matrix3Xd& f, double tau) const {
    Matrix3Xd v = velocity;
    for (Eigen::Index a = 0; a < f.cols(); ++a) v.col(a) += tau / mass(a) * f.col(a);
    return v;
  }
};

// --- free sphere: momenta
// ------------------------------------------------------------------------------------

TEST(ContactMotion, momenta_are_conserved_to_round_off) {
  MovingSkin s;
  s.spring = 0.0;
  const auto model = scenes::contact(s.skin, kRadius, kSoft);
  auto state = model.make_state();
  const double mass = 0.05;
  Vector3d centre(0.003, -0.002, 1.1 * kRadius), velocity(0.3, 0.1, -2.0);
  const auto momentum = [&] { return Vector3d(s.velocity * s.masses().transpose() + mass * velocity); };
  const auto spin = [&] {
    Vector3d sum = mass * centre.cross(velocity);
    for (Eigen::Index a = 0; a < s.velocity.cols(); ++a)
      sum += s.mass(a) * Vector3d(s.skin.nodes.col(a)).cross(Vector3d(s.velocity.col(a)));
    return sum;
  };
  const Vector3d momentum0 = momentum(), spin0 = spin();
  double before = 0.0, impulse = 0.0;
  for (int n = 0; n < 2000; ++n) {
    const double dt = 2e-5 * (1.0 + 0.5 * std::sin(0.1 * n)), tau = 0.5 * (before + dt);
    Matrix3Xd f = Matrix3Xd::Zero(3, s.velocity.cols());
    const auto contact = model.evaluate(state, s.skin.nodes, {centre}, f);
    s.velocity = s.kicked(f, tau);
    velocity += tau / mass * contact.force;
    s.skin.nodes += dt * s.velocity;
    centre += dt * velocity;
    impulse += tau * contact.force.norm();
    before = dt;
  }
  ASSERT_GT(impulse, 0.02);
  const double scale = impulse + momentum0.norm();
  claim::expect_near({"K.11", "sphere bounces on free skin: change of linear momentum [kg m/s]",
                      "2000 steps of a few roundings of what is passed on"},
                     (momentum() - momentum0).norm(), 0.0, 1e-13 * scale);
  claim::expect_near({"K.11", "the same: change of angular momentum [kg m2/s]", "arms below 1 m"},
                     (spin() - spin0).norm(), 0.0, 1e-13 * scale);
}

// --- pendulum
// ------------------------------------------------------------------------------------------------

struct Books {
  double drift = 0.0;        // [J] physical energy against that at the start, largest difference
  double supplied = 0.0;     // [J] sum of |kick work|
  double kick_gap = 0.0;     // [J] kinetic energy gained less kick work
  double penetration = 0.0;  // [m] largest
};

// The paper's pendulum, lightened so that it rebounds, falls on the sprung skin from above with gravity on.
coupling::PendulumModel light_pendulum() {
  auto p = scenes::paper_pendulum();
  p.axis = {0.0, 1.0, 0.0};
  p.rest_direction = {1.0, 0.0, 0.0};
  p.mass = 0.06;
  p.inertia_cg = 0.01;
  p.pivot = {-p.impactor_distance + 0.003, -0.002, 1.02 * kRadius};
  return coupling::PendulumModel(p);
}

template <class Step>
Books bounce(double duration, Step step_size) {
  MovingSkin s;
  const auto pendulum = light_pendulum();
  const auto model = scenes::contact(s.skin, kRadius, kSoft, pendulum.effective_mass());
  auto state = model.make_state();
  coupling::PendulumState swing{0.0, 1.5};
  Books books;
  double before = 0.0, work = 0.0, first_energy = 0.0, first_kinetic = 0.0;
  double time = 0.0;
  for (int n = 0;; ++n) {
    const bool last = time > duration * (1.0 - 1e-9);
    const double dt = last ? 0.0 : step_size(n), tau = 0.5 * (before + dt);
    Matrix3Xd f = Matrix3Xd::Zero(3, s.velocity.cols());
    const Vector3d centre = pendulum.impactor_centre(swing.angle);
    const auto contact = model.evaluate(state, s.skin.nodes, {centre}, f);
    books.penetration = std::max(books.penetration, contact.penetration);
    s.add_springs(f);
    const double moment = pendulum.moment(contact.force, centre) + pendulum.gravity_moment(swing.angle);
    const Matrix3Xd level = s.kicked(f, 0.5 * before), after = s.kicked(f, tau);
    const double omega_level = pendulum.angular_velocity_at_level(swing, moment, before);
    const double energy = s.kinetic(level) + pendulum.kinetic_energy(omega_level) + contact.energy +
                          s.spring_energy() + pendulum.potential_energy(swing.angle);
    if (n == 0) first_energy = energy;
    if (n == 0) first_kinetic = s.kinetic(s.velocity) + pendulum.kinetic_energy(swing.angular_velocity);
    books.drift = std::max(books.drift, std::abs(energy - first_energy));
    if (last) {
      books.kick_gap =
          s.kinetic(s.velocity) + pendulum.kinetic_energy(swing.angular_velocity) - first_kinetic - work;
      return books;
    }
    const auto next = pendulum.advance(swing, moment, tau, dt);
    const double kick = 0.5 * tau *
                        (f.cwiseProduct(s.velocity + after).sum() +
                         moment * (swing.angular_velocity + next.angular_velocity));
    work += kick;
    books.supplied += std::abs(kick);
    s.velocity = after;
    s.skin.nodes += dt * s.velocity;
    swing = next;
    before = dt;
    time += dt;
  }
}

TEST(ContactMotion, kick_ledger_closes_for_varying_steps) {
  const Books books = bounce(0.01, [](int n) { return 2e-5 * (1.0 + 0.5 * std::sin(0.3 * n)); });
  ASSERT_GT(books.penetration, 1e-3);
  claim::expect_near({"K.20", "pendulum and skin in contact, varying steps: residual of (K.20) [J]",
                      "500 steps, sums over 243 components: of all the work"},
                     books.kick_gap, 0.0, 1e-12 * books.supplied);
}

// The bounce lasts 4 ms.
TEST(ContactMotion, physical_energy_drift_is_of_order_2) {
  std::vector<double> drift;
  for (int level = 0; level < 3; ++level) {
    const double dt = 5e-6 / (1 << level);
    const Books books = bounce(6e-3, [dt](int) { return dt; });
    ASSERT_GT(books.penetration, 1e-3);
    drift.push_back(books.drift);
  }
  claim::expect_order(
      {"K.21", "pendulum that bounces on sprung nodes: drift of energy",
       "steps in which points come into touch are off by dt^3: scatter, below 0.1 from 5 us on"},
      drift, 1.9, 2.1);
}

}  // namespace
