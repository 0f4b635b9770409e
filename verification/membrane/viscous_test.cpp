// SPDX-License-Identifier: Apache-2.0
// Stiffness-proportional damping (M.28), (M.29).
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "claim.hpp"
#include "closed_form/membrane.hpp"
#include "scenes.hpp"

using membrane::Compression;

namespace {

constexpr double kBreather = 0.3, kStressLag = 1e-4;  // [m], [s]

// The icosahedron's nodes are all alike: it breathes with one degree of freedom.
membrane::BagModel breather_model() {
  auto d = scenes::describe(mesh::icosphere(kBreather, 0), Compression::linear);
  d.stiffness_damping = kStressLag;
  return make_model(d);
}

// omega^2 of its small breathing [1/s2].
double breathing(const membrane::BagModel& model) {
  constexpr double stretch = 1e-7;
  const auto& x = model.description.reference;
  const auto force = [&](double by) {
    return scenes::evaluated(model, (1.0 + by) * x).membrane_force.map().col(0).dot(x.col(0).normalized());
  };
  return (force(-stretch) - force(stretch)) / (2.0 * stretch * kBreather * model.node_mass[0]);
}

// Radius over that of rest, less 1 and over the first, after `steps` steps of dt.
double swing_after(const membrane::BagModel& model, double dt, int steps) {
  constexpr double first = 1e-6;
  auto state = membrane::make_state(model, (1.0 + first) * model.description.reference);
  for (int i = 0; i < steps; ++i) {
    membrane::update_skin(model, state);
    membrane::viscous_forces(model, state, i > 0 ? dt : 0.0);
    membrane::advance(model, state, i > 0 ? dt : 0.0, dt);
  }
  return (state.position.map().col(0).norm() / kBreather - 1.0) / first;
}

TEST(Viscous, breathing_decays_with_order_1) {
  const auto model = breather_model();
  const double omega = std::sqrt(breathing(model)), end = 3.0 * 2.0 * M_PI / omega;
  const double exact = closed_form::damped_swing(omega, kStressLag, end);
  std::vector<double> errors;
  for (const int steps : {6400, 12800, 25600})
    errors.push_back(swing_after(model, end / steps, steps) - exact);
  claim::expect_order({"M.28", "breathing icosahedron with stiffness damping: swing after three periods",
                       "the rate is that of half a step ago; terms of second order are 4 % of it"},
                      errors, 0.98, 1.05);
}

// Largest displacement over the kick after some steps of `dt`, from rest in the shape as sewn.
double growth_of_kick(const membrane::BagModel& model, double dt, int steps) {
  constexpr double kick = 1e-12;
  const auto& x = model.description.reference;
  auto state = membrane::make_state(model, scenes::shaken(x, kick, 3));
  for (int i = 0; i < steps; ++i) {
    membrane::update_skin(model, state);
    membrane::viscous_forces(model, state, i > 0 ? dt : 0.0);
    membrane::advance(model, state, i > 0 ? dt : 0.0, dt);
  }
  return (state.position.map() - x).cwiseAbs().maxCoeff() / kick;
}

// (M.29), with the bound (M.10) of omega^2, which the lone elements of the icosahedron take to a half.
TEST(Viscous, bound_of_the_step_holds_for_stiffness_and_lagged_damping) {
  const auto model = breather_model();
  const auto state = scenes::evaluated(model, model.description.reference);
  const double frequency = state.forces.element_frequency, rate = kStressLag * frequency;
  const double bound = membrane::critical_time_step(membrane::stiffness_shares(model, state, 0.0, 0.0));
  EXPECT_NEAR(bound, 4.0 / (rate + std::sqrt(rate * rate + 4.0 * frequency)), 10.0 * scenes::kEps * bound);
  EXPECT_LT(bound, 0.9 * 2.0 / std::sqrt(frequency));  // the damping does shorten it
  EXPECT_LT(growth_of_kick(model, bound, 120), 100.0);
  EXPECT_GT(growth_of_kick(model, 2.0 * bound, 12), 1e4);
}

// A fine sphere whose pressure is switched on: the damping, which takes a half to nine tenths off the step,
// has to take energy at nine tenths of the bound.
TEST(Viscous, pressed_sphere_comes_to_rest_at_the_critical_step) {
  const auto mesh = mesh::icosphere(kBreather, 2);
  for (const double lag : {1e-4, 1e-3}) {
    auto d = scenes::describe(mesh, Compression::none);
    d.stiffness_damping = lag;
    const auto model = make_model(d);
    auto state = membrane::make_state(model, mesh.nodes);
    double most = 0.0;
    for (double time = 0.0, before = 0.0, dt = 0.0; time < 0.05; time += dt, before = dt) {
      membrane::update_skin(model, state);
      membrane::pressure_forces(state, 2e3);
      membrane::viscous_forces(model, state, before);
      dt = 0.9 * membrane::critical_time_step(membrane::stiffness_shares(model, state, 0.0, 0.0));
      ASSERT_NO_THROW(membrane::advance(model, state, before, dt)) << lag << " s, at " << time << " s";
      most = std::max(most, state.advance.kinetic_after);
    }
    EXPECT_LT(state.advance.kinetic_after, 1e-3 * most) << lag << " s";
  }
}

TEST(Viscous, rigid_motion_is_not_damped_and_forces_sum_to_zero) {
  const auto mesh = mesh::icosphere(kBreather, 2);
  auto d = scenes::describe(mesh, Compression::none);
  d.stiffness_damping = kStressLag;
  for (int e = 0; e < 5; ++e) d.properties[static_cast<std::size_t>(e)].porosity = 0.0;
  const auto model = make_model(d);
  auto state = membrane::make_state(model, scenes::shaken(1.1 * mesh.nodes, 0.01, 3));
  membrane::viscous_forces(model, state, 0.0);
  EXPECT_EQ(state.viscous.force.map().norm(), 0.0);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
  const Eigen::Matrix3Xd before = state.position.map();
  state.position.map() = (turn * before).colwise() + Eigen::Vector3d(0.1, 0.2, 0.3);
  membrane::viscous_forces(model, state, 1e-5);
  // The stress is of 1e7 Pa, its rate over 1e-5 s from rounding of the strain; h a side 0.5e-3 m x 0.1 m.
  const double rounding = 100.0 * scenes::kEps * 60e6 * kStressLag / 1e-5 * 0.5e-4;
  EXPECT_LT(state.viscous.force.map().cwiseAbs().maxCoeff(), rounding);
  const Eigen::Matrix3Xd again = state.position.map();
  state.position.map() = scenes::shaken(again, 0.001, 4);
  membrane::viscous_forces(model, state, 1e-5);
  const Eigen::Matrix3Xd force = state.viscous.force.map();
  EXPECT_GT(force.norm(), 1.0);
  EXPECT_LT(force.rowwise().sum().norm(), 1e-12 * force.cwiseAbs().sum());
  EXPECT_LT(force.cwiseProduct(state.position.map() - again).sum(), 0.0);  // it takes energy
}

}  // namespace
