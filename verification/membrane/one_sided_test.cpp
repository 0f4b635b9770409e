// SPDX-License-Identifier: Apache-2.0
// What a one-sided spring adds to the energy (M.23), and the rates that bound it (M.22).
#include <gtest/gtest.h>

#include <numbers>

#include "claim.hpp"
#include "membrane/time_step.hpp"
#include "mesh/icosphere.hpp"
#include "scenes.hpp"

using membrane::Compression;

namespace {

constexpr double kStiffness = 1e8, kSpeed = 3.0;                 // of the plate [N/m3], of the triangle [m/s]
const double kOmega = std::sqrt(kStiffness / (620.0 * 0.5e-3));  // kappa / (rho h)

// Kinetic energy after a bounce over that before: a triangle that flies flat onto a plate, first `phase` of a
// step away from it at a level.
double gain(double dt, double phase) {
  mesh::Mesh mesh;
  mesh.nodes.resize(3, 3);
  mesh.nodes << 0.0, 0.1, 0.0, 0.0, 0.0, 0.1, 0.0, 0.0, 0.0;
  mesh.elements.resize(3, 1);
  mesh.elements << 0, 1, 2;
  auto d = scenes::describe(mesh, Compression::none);
  d.plates = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), kStiffness}};
  const auto model = make_model(d);
  Eigen::Matrix3Xd x = mesh.nodes;
  x.row(2).setConstant(phase * kSpeed * dt);
  auto state = membrane::make_state(model, x);
  state.velocity.map().row(2).setConstant(-kSpeed);
  const auto height = [&] { return state.position.map()(2, 0); };
  const auto speed = [&] { return state.velocity.map()(2, 0); };
  do {
    membrane::membrane_forces(model, state);
    membrane::support_forces(model, state);
    membrane::advance(model, state, dt, dt);
  } while (height() < 0.0 || speed() < 0.0);
  return std::pow(speed() / kSpeed, 2);
}

}  // namespace

// The steps at which a spring that closes at a level opens half way between two: a half turn and half a step.
TEST(OneSided, largest_gain_of_a_bounce_eq_formula) {
  for (const int steps : {1, 2, 3, 8, 31}) {
    const double dt = 2.0 / kOmega * std::sin(std::numbers::pi / (2 * steps + 1));
    const double predicted = 1.0 / (1.0 - 0.25 * std::pow(kOmega * dt, 2));
    double largest = 0.0, least = 1.0;
    for (int i = 0; i < 200; ++i) {
      largest = std::max(largest, gain(dt, i / 200.0));
      least = std::min(least, gain(dt, i / 200.0));
    }
    claim::expect_threshold(
        {"M.23", "ω Δt = " + std::to_string(kOmega * dt).substr(0, 5),
         "the phase that gains most is one of the 200 tried; rounding of some ten steps"},
        {"one-sided spring: largest energy after a bounce over that before", "E/E₀ = 1/(1 − ω²Δt²/4)",
         predicted, largest, "-",
         "straps: Δt follows (M.22); plate and contact: of single nodes, whose energy is small"},
        1.0 - 1e-9, 1.0 + 1e-9);
    EXPECT_GE(least, (1.0 - 1e-9) / predicted);  // and no bounce loses more
  }
}

TEST(OneSided, force_mobility_eq_square_of_the_kick) {
  auto d = scenes::describe(mesh::icosphere(0.3, 1), Compression::none);
  d.straps = {{0, 20, 4500.0, 0.2}};
  d.plates = {{{0.1, 0.0, 0.0}, {1.0, 0.0, 0.0}, 1e6}};
  d.fixed_nodes = {3};
  const auto model = make_model(d);
  auto state = scenes::evaluated(model, scenes::shaken(1.05 * d.reference, 0.01, 6));
  membrane::pressure_forces(state, 2e4);
  const double mobility = membrane::force_mobility(model, state);
  const double dt = 1e-5, tau = 0.5 * dt;
  const auto& sums = membrane::advance(model, state, 0.0, dt);  // from rest: |tau f / m|^2 m / 2
  EXPECT_GT(mobility, 0.0);
  EXPECT_NEAR(2.0 * sums.kinetic_after / (tau * tau) / mobility, 1.0, 1e-12);
  EXPECT_NEAR(
      2.0 * (sums.kinetic_before + sums.kinetic_after - 2.0 * sums.kinetic_product) / (tau * tau) / mobility,
      1.0, 1e-12);
}

// k v^2 + T^2 (1/m_a + 1/m_b), written out; a slack strap counts what it closes with.
TEST(OneSided, strap_mobility_counts_pull_and_parting) {
  auto d = scenes::describe(mesh::icosphere(0.3, 1), Compression::none);
  const double distance = (d.reference.col(20) - d.reference.col(0)).norm();
  d.straps = {{0, 20, 4500.0, 0.9 * distance}, {0, 20, 7000.0, 1.1 * distance}};
  d.fixed_nodes = {20};
  const auto model = make_model(d);
  auto state = scenes::evaluated(model, d.reference);
  const Eigen::Vector3d along = (d.reference.col(20) - d.reference.col(0)) / distance;
  state.velocity.map().col(0) = 2.0 * along + along.unitOrthogonal();
  const double exact = (4500.0 + 7000.0) * 4.0 + std::pow(4500.0 * 0.1 * distance, 2) / model.node_mass[0];
  EXPECT_NEAR(membrane::strap_mobility(model, state) / exact, 1.0, 1e-12);
}
