// SPDX-License-Identifier: Apache-2.0
// Books of the central difference (M.9): exact for any force and any sequence of steps.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "membrane/error.hpp"
#include "scenes.hpp"

using membrane::Compression;

namespace {

struct Case {
  membrane::BagModel model;
  membrane::BagState state;
};

// Everything at once: pressure, jet, contact, straps, plate, gravity, damping, fixed nodes, random motion.
Case loaded_sphere(double damping) {
  const auto mesh = mesh::icosphere(0.3, 2);
  auto d = scenes::describe(mesh, Compression::none);
  d.straps = {{0, 100, 4500.0, 0.2}};
  d.plates = {{{-0.28, 0.0, 0.0}, {1.0, 0.0, 0.0}, 1e6}};
  d.fixed_nodes = {3, 50};
  d.held_nodes = {{{20, 21}, {}, {21, 60}}};
  d.gravity = {1.0, -2.0, -9.81};
  d.mass_damping = damping;
  auto model = make_model(d);
  auto state =
      membrane::make_state(model, scenes::shaken(mesh.nodes, 0.01, 1), {.jet = true, .contact = true});
  state.velocity.map() = 5.0 * scenes::Random(2).vectors(mesh.node_count());
  for (int i = 0; i < state.velocity.map().size(); ++i)
    if (model.inverse_mass.map()(i % 3, i / 3) == 0.0) state.velocity.map()(i % 3, i / 3) = 0.0;
  return {std::move(model), std::move(state)};
}

void load(Case& c, scenes::Random& random, std::vector<double>& dp) {
  membrane::update_surface(c.model, c.state);
  membrane::update_geometry(c.model, c.state);
  membrane::membrane_forces(c.model, c.state);
  membrane::pressure_forces(c.state, 2e4 * random());
  for (double& value : dp) value = 1e4 * random();
  membrane::jet_forces(c.model, c.state, dp);
  membrane::support_forces(c.model, c.state);
  c.state.contact_force.map() = 10.0 * random.vectors(c.model.node_count);
}

}  // namespace

TEST(Books, kick_ledger_closes_for_any_force_and_step) {
  for (const double damping : {0.0, 20.0, 5e4}) {
    auto c = loaded_sphere(damping);
    scenes::Random random(9);
    std::vector<double> dp(static_cast<std::size_t>(c.model.element_count));
    double dt_before = 0.0;
    for (int step = 0; step < 50; ++step) {
      load(c, random, dp);
      const double dt_after = 4e-5 * (1.0 + 0.9 * random());
      const auto& sums = membrane::advance(c.model, c.state, dt_before, dt_after);
      const auto& w = sums.work;
      const double size = sums.kinetic_before + sums.kinetic_after + std::abs(w.membrane) +
                          std::abs(w.pressure) + std::abs(w.jet) + std::abs(w.support) + std::abs(w.contact) +
                          std::abs(w.gravity) + std::abs(w.damping);
      // Each term is a sum over 162 nodes of a few products: 1e-13 is 450 eps.
      EXPECT_NEAR(sums.kinetic_after - sums.kinetic_before, w.total(), 1e-13 * size) << step;
      dt_before = dt_after;
    }
  }
}

// K_n = v- . M v+ / 2 and the work (f_n + f_n+1) / 2 . dx balance to round-off for any force, one step
// length.
TEST(Books, work_of_mean_forces_closes_for_constant_step) {
  auto c = loaded_sphere(0.0);
  scenes::Random random(9);
  std::vector<double> dp(static_cast<std::size_t>(c.model.element_count));
  const double dt = 3e-5;
  Eigen::Matrix3Xd force_before, moved;
  double kinetic_before = 0.0, work = 0.0, first = 0.0, size = 0.0;
  for (int step = 0; step < 50; ++step) {
    load(c, random, dp);
    Eigen::Matrix3Xd force = c.state.membrane_force.map() + c.state.jet_force.map() +
                             c.state.support_force.map() + c.state.contact_force.map() +
                             c.state.gauge_pressure * c.state.volume_gradient.map();
    for (int n = 0; n < c.model.node_count; ++n)
      force.col(n) += c.model.node_mass[static_cast<std::size_t>(n)] * c.model.description.gravity;
    const Eigen::Matrix3Xd before = c.state.position.map();
    const double kinetic = membrane::advance(c.model, c.state, dt, dt).kinetic_product;
    if (step == 0) first = kinetic;
    if (step > 0) work += 0.5 * (force_before + force).cwiseProduct(moved).sum();
    size += std::abs(kinetic - kinetic_before) + std::abs(kinetic);
    // Displacements of 1e-4 m are differences of positions of 0.3 m: 3000 eps, each step anew.
    EXPECT_NEAR(kinetic - first, work, 3000 * scenes::kEps * size) << step;
    moved = c.state.position.map() - before;
    force_before = force;
    kinetic_before = kinetic;
  }
}

TEST(Books, momentum_change_eq_impulse_without_damping) {
  auto c = loaded_sphere(0.0);
  scenes::Random random(9);
  std::vector<double> dp(static_cast<std::size_t>(c.model.element_count));
  for (int step = 0; step < 20; ++step) {
    load(c, random, dp);
    const auto& sums = membrane::advance(c.model, c.state, 2e-5, 3e-5);
    const Eigen::Vector3d change = sums.momentum_after - sums.momentum_before;
    // 162 terms of at most 1e-3 kg x 50 m/s.
    EXPECT_LE((change - sums.impulse).norm(), 162 * 4 * scenes::kEps * 0.05);
  }
}

TEST(Books, fixed_nodes_stay) {
  auto c = loaded_sphere(0.0);
  const Eigen::Vector3d before = c.state.position.map().col(50);
  scenes::Random random(9);
  std::vector<double> dp(static_cast<std::size_t>(c.model.element_count));
  for (int step = 0; step < 10; ++step) {
    load(c, random, dp);
    membrane::advance(c.model, c.state, 2e-5, 2e-5);
  }
  EXPECT_EQ((c.state.position.map().col(50) - before).norm(), 0.0);
}

TEST(Books, rollers_hold_their_directions_alone) {
  auto c = loaded_sphere(0.0);
  const Eigen::Matrix3Xd before = c.state.position.map();
  scenes::Random random(9);
  std::vector<double> dp(static_cast<std::size_t>(c.model.element_count));
  for (int step = 0; step < 10; ++step) {
    load(c, random, dp);
    membrane::advance(c.model, c.state, 2e-5, 2e-5);
  }
  const Eigen::Matrix3Xd moved = c.state.position.map() - before;
  for (const int node : {20, 21, 60})
    for (int axis = 0; axis < 3; ++axis) {
      const bool held = axis == 0 ? node != 60 : axis == 2 && node != 20;
      EXPECT_EQ(moved(axis, node) == 0.0, held) << node << ' ' << axis;
    }
}

TEST(Books, damping_eq_exact_implicit_decay) {
  // A lone drifting sheet: v+ = v- (1 - alpha tau / 2) / (1 + alpha tau / 2).
  const auto sheet = mesh::rectangle(2, 2, 0.2, 0.2, mesh::Diagonals::uniform);
  auto d = scenes::describe(sheet, Compression::none);
  d.mass_damping = 100.0;
  const auto model = make_model(d);
  auto state = membrane::make_state(model, sheet.nodes);
  state.velocity.map().colwise() = Eigen::Vector3d(1.0, 2.0, 3.0);
  membrane::membrane_forces(model, state);
  membrane::advance(model, state, 1e-3, 1e-3);
  EXPECT_NEAR(state.velocity.map()(2, 4), 3.0 * 0.95 / 1.05, 16 * scenes::kEps);
}

TEST(Books, free_flight_conserves_momentum_and_angular_momentum) {
  const auto mesh = mesh::icosphere(0.3, 2);
  const auto model = make_model(scenes::describe(mesh, Compression::none));
  auto state = membrane::make_state(model, mesh.nodes);
  const Eigen::Vector3d spin(20.0, -10.0, 30.0);
  for (int n = 0; n < model.node_count; ++n)
    state.velocity.map().col(n) =
        Eigen::Vector3d(3.0, 1.0, -2.0) + spin.cross(Eigen::Vector3d(mesh.nodes.col(n)));
  const auto angular_momentum = [&] {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int n = 0; n < model.node_count; ++n)
      sum += model.node_mass[static_cast<std::size_t>(n)] *
             Eigen::Vector3d(state.position.map().col(n)).cross(Eigen::Vector3d(state.velocity.map().col(n)));
    return sum;
  };
  const Eigen::Vector3d before = angular_momentum();
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
  for (int step = 0; step < 1000; ++step) {
    membrane::membrane_forces(model, state);
    const auto& sums = membrane::advance(model, state, step == 0 ? 0.0 : 5e-5, 5e-5);
    if (step == 0) momentum = sums.momentum_before;
    // Per step eps x the largest corner force (about 10 N) x dt x nodes, and as much in the moment.
    ASSERT_LE((sums.momentum_after - momentum).norm(), 1000 * 162 * 6 * scenes::kEps * 10.0 * 5e-5);
  }
  // One step shifts x by dt v, which has no moment with m v; x reaches 0.4 m.
  EXPECT_LE((angular_momentum() - before).norm(), 1000 * 162 * 6 * scenes::kEps * 10.0 * 5e-5);
}

TEST(Books, level_kinetic_is_that_of_the_velocity_between) {
  // A mass of 3 kg at v with acceleration a: v at n-1/2 and n+1/2, and |v|^2 less dt_before dt_after |a|^2
  // / 4.
  const Eigen::Vector3d v(1.0, -2.0, 0.5), a(4.0, 8.0, -6.0);
  for (const auto& [before, after] : {std::pair{0.25, 0.25}, {0.125, 0.5}, {0.0, 0.5}}) {
    const Eigen::Vector3d early = v - 0.5 * before * a, late = v + 0.5 * after * a;
    membrane::AdvanceSums sums;
    sums.kinetic_before = 1.5 * early.squaredNorm();
    sums.kinetic_after = 1.5 * late.squaredNorm();
    sums.kinetic_product = 1.5 * early.dot(late);
    EXPECT_NEAR(membrane::level_kinetic(sums, before, after),
                1.5 * (v.squaredNorm() - before * after * a.squaredNorm() / 4.0), 100.0 * scenes::kEps);
  }
  EXPECT_THROW(membrane::level_kinetic({}, -1.0, 1.0), std::invalid_argument);
}

// (M.22) A start from rest lacks dt^2 / 8 f^T M^-1 f at the next level: the share 1e-4 of the energy asked
// for.
TEST(Books, start_at_the_energy_step_lacks_its_share_of_the_energy) {
  const auto mesh = mesh::icosphere(0.3, 2);
  const auto model = make_model(scenes::describe(mesh, membrane::Compression::linear));
  auto state = scenes::evaluated(model, 1.01 * mesh.nodes);
  const double energy = state.forces.strain_energy, mobility = membrane::force_mobility(model, state);
  const double dt = membrane::energy_time_step(model, state, energy, mobility, true);
  membrane::advance(model, state, 0.0, dt);
  membrane::update_skin(model, state);
  const double strain = state.forces.strain_energy;
  membrane::advance(model, state, dt, dt);
  const double drift = (membrane::level_kinetic(state.advance, dt, dt) + strain) / energy - 1.0;
  EXPECT_NEAR(drift, -1e-4, 1e-6);  // the next terms are (omega dt)^2 = 4e-4 of it, and 1 % of stretch
  EXPECT_EQ(membrane::energy_time_step(model, state, energy, 0.0, true), membrane::bounce_time_step(model));
  for (const double bad : {-1.0, std::nan("")}) {
    EXPECT_THROW(membrane::energy_time_step(model, state, bad, mobility, true), std::invalid_argument);
    EXPECT_THROW(membrane::energy_time_step(model, state, energy, bad, true), std::invalid_argument);
  }
}

TEST(Books, non_finite_motion_is_caught_at_once) {
  auto c = loaded_sphere(0.0);
  membrane::update_surface(c.model, c.state);
  membrane::update_geometry(c.model, c.state);
  membrane::membrane_forces(c.model, c.state);
  c.state.contact_force.map()(1, 17) = std::numeric_limits<double>::quiet_NaN();
  try {
    membrane::advance(c.model, c.state, 1e-5, 1e-5);
    FAIL() << "accepted";
  } catch (const membrane::MembraneError& error) {
    EXPECT_NE(std::string(error.what()).find("node 17"), std::string::npos) << error.what();
  }
  EXPECT_THROW(membrane::pressure_forces(c.state, std::numeric_limits<double>::infinity()),
               membrane::MembraneError);
}
