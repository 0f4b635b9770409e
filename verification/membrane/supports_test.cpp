// SPDX-License-Identifier: Apache-2.0
// Straps (M.7) and plates (M.8).
#include <gtest/gtest.h>

#include "claim.hpp"
#include "energy_derivative.hpp"
#include "scenes.hpp"

using membrane::Compression;

namespace {

membrane::BagDescription supported_sphere() {
  auto d = scenes::describe(mesh::icosphere(0.3, 1), Compression::none);
  d.straps = {{0, 20, 4500.0, 0.3}, {0, 30, 3000.0, 0.35}, {5, 6, 4500.0, 5.0}};
  d.plates = {{{-0.2, 0.0, 0.0}, {2.0, 0.0, 0.5}, 1e6}, {{0.0, 0.25, 0.0}, {0.0, -1.0, 0.0}, 2e6}};
  return d;
}

double support_energy(const membrane::BagModel& model, const Eigen::Matrix3Xd& x) {
  const auto state = scenes::evaluated(model, x);
  return state.forces.strap_energy + state.forces.plate_energy;
}

}  // namespace

TEST(Supports, force_eq_minus_energy_derivative) {
  const auto d = supported_sphere();
  const auto model = make_model(d);
  const Eigen::Matrix3Xd x = scenes::shaken(d.reference, 0.05, 3);
  const auto state = scenes::evaluated(model, x);
  EXPECT_GT(state.forces.strap_energy, 1.0);
  EXPECT_GT(state.forces.plate_energy, 1.0);
  // eps x 500 J / h = 1e-7 N; a node that leaves the plate within h errs by stiffness 3e4 N/m x h.
  scenes::expect_eq_minus_derivative(
      state.support_force.map(), x, [&](const Eigen::Matrix3Xd& at) { return support_energy(model, at); },
      0.03);
}

TEST(Supports, strap_pulls_and_never_pushes) {
  auto d = scenes::describe(mesh::icosphere(0.3, 0), Compression::none);
  d.straps = {{0, 1, 4500.0, 0.5}};
  const auto model = make_model(d);
  for (const double length : {0.2, 0.5, 0.6}) {
    Eigen::Matrix3Xd x = d.reference;
    x.col(1) = x.col(0) + length * Eigen::Vector3d(0.0, 0.6, 0.8);
    const auto state = scenes::evaluated(model, x);
    const double expected = std::max(0.0, 4500.0 * (length - 0.5));
    const double allowed = 4500.0 * 8 * scenes::kEps;  // rounding of lengths below 1 m
    claim::expect_near({"M.7", "strap, slack and taut: tension [N]", "rounding of lengths below 1 m"},
                       state.strap_tension[0], expected, allowed);
    EXPECT_NEAR(state.support_force.map()(2, 0), 0.8 * expected, allowed);
    EXPECT_NEAR(state.support_force.map()(2, 1), -0.8 * expected, allowed);
    EXPECT_NEAR(state.forces.strap_energy, 0.5 * expected * std::max(0.0, length - 0.5), allowed);
  }
}

TEST(Supports, plate_pressure_eq_stiffness_times_depth) {
  // A flat sheet pushed d behind the plate feels kappa d on its area.
  const auto sheet = mesh::rectangle(4, 3, 0.4, 0.3, mesh::Diagonals::uniform);
  auto d = scenes::describe(sheet, Compression::none);
  d.plates = {{{0.0, 0.0, 0.01}, {0.0, 0.0, 3.0}, 1e6}};
  const auto state = scenes::evaluated(make_model(d), sheet.nodes);
  const double force = 1e6 * 0.01 * 0.12, energy = 0.5 * force * 0.01;
  claim::expect_relative({"M.8", "sheet 10 mm behind a plate: force [N]", "100 roundings"},
                         state.support_force.map().row(2).sum(), force, 100 * scenes::kEps);
  EXPECT_NEAR(state.forces.plate_energy, energy, 100 * scenes::kEps * energy);
  d.plates[0].normal *= -1.0;  // now the sheet is on the free side
  EXPECT_EQ(scenes::evaluated(make_model(d), sheet.nodes).forces.plate_energy, 0.0);
}

// A slack sheet thrown against a plate leaves with the speed it came with: order 2 in the step.
TEST(Supports, plate_without_stiffness_adds_its_share) {
  auto d = scenes::describe(mesh::icosphere(0.3, 2), Compression::none);
  d.plates = {{{-0.2, 0.0, 0.0}, {1.0, 0.0, 0.0}, {}}};
  const auto model = make_model(d);
  // Uniform fabric: every node has the same mass per area, to the rounding of sums of six elements.
  EXPECT_NEAR(model.plate_frequency / model.fabric_frequency, 0.25, 16 * scenes::kEps);
}

// (M.24) omega^2 dt^2 = 1.5: a bounce by (M.23) then leaves with 1 / (1 - 1.5 / 4) = 1.6 of its energy at
// most.
TEST(Supports, bounce_at_its_step_gains_at_most_60_percent) {
  auto d = supported_sphere();
  const auto model = make_model(d);
  const double dt = membrane::bounce_time_step(model);
  EXPECT_NEAR(1.0 / (1.0 - 0.25 * dt * dt * (model.strap_frequency + model.plate_frequency)), 1.6, 1e-14);
  d.straps.clear();
  d.plates.clear();
  EXPECT_EQ(membrane::bounce_time_step(make_model(d)), std::numeric_limits<double>::infinity());
}

TEST(Supports, bounce_on_plate_conserves_energy) {
  const auto sheet = mesh::rectangle(2, 2, 0.2, 0.2, mesh::Diagonals::union_jack);
  auto d = scenes::describe(sheet, Compression::none);
  d.plates = {{{0.0, 0.0, -0.01}, {0.0, 0.0, 1.0}, 1e6}};
  const auto model = make_model(d);
  const auto speed_after = [&](int steps) {
    auto state = membrane::make_state(model, sheet.nodes);
    state.velocity.map().row(2).setConstant(-5.0);
    const double dt = 6e-3 / steps;
    for (int i = 0; i < steps; ++i) {
      membrane::membrane_forces(model, state);
      membrane::support_forces(model, state);
      membrane::advance(model, state, i == 0 ? 0.0 : dt, dt);
    }
    return state.velocity.map()(2, 4);
  };
  // kappa / (rho h) = (1796 rad/s)^2, dt = 3e-6 s: (omega dt)^2 = 3e-5 of the speed, times a small constant.
  EXPECT_NEAR(speed_after(2000), 5.0, 5.0 * 3e-5);
  EXPECT_NEAR(speed_after(8000), 5.0, 5.0 * 3e-5 / 8.0);
}
