// SPDX-License-Identifier: Apache-2.0
// Order of the central difference on a smooth oscillation with variable steps (M.9).
#include <gtest/gtest.h>

#include <numbers>

#include "claim.hpp"
#include "scenes.hpp"

using membrane::Compression;

namespace {

constexpr double kEnd = 2e-3;  // [s], half a breathing period of the inflated sphere

// Smoothly varying steps that nest when their number doubles.
double time_at(double s) {
  return kEnd * (s + 0.1 * std::sin(2.0 * std::numbers::pi * s));
}

struct End {
  Eigen::Matrix3Xd x;
  double energy_drift;  // total energy at the end less at the start [J]
};

// A sphere under constant pressure, off its equilibrium and moving, ovally, always taut.
End run(int steps) {
  const auto mesh = mesh::icosphere(0.3, 1);
  const auto model = make_model(scenes::describe(mesh, Compression::none));
  const double pressure = 2e4;
  Eigen::Matrix3Xd x = 1.09 * mesh.nodes;
  x.row(2) *= 1.01;
  auto state = membrane::make_state(model, x);
  state.velocity.map() = 15.0 * mesh.nodes;
  double before = 0.0, first_energy = 0.0, last_energy = 0.0;
  for (int i = 0; i < steps; ++i) {
    membrane::update_surface(model, state);
    membrane::membrane_forces(model, state);
    membrane::pressure_forces(state, pressure);
    const double after = time_at((i + 1.0) / steps) - time_at(static_cast<double>(i) / steps);
    const auto& sums = membrane::advance(model, state, before, after);
    const double kinetic = i == 0 ? sums.kinetic_before : 0.5 * (sums.kinetic_before + sums.kinetic_after);
    last_energy = state.forces.strain_energy - pressure * state.surface.volume + kinetic;
    if (i == 0) first_energy = last_energy;
    before = after;
  }
  return {state.position.map(), last_energy - first_energy};
}

}  // namespace

TEST(Oscillation, central_difference_has_order_2_with_variable_steps) {
  const Eigen::Matrix3Xd reference = run(64 * 128).x;
  std::vector<double> error;
  for (int level = 0; level < 4; ++level) error.push_back((run(128 << level).x - reference).norm());
  claim::expect_order({"M.9", "oscillating sphere, variable steps: positions",
                       "the reference, of eight times the steps, leaves 1/64 of the finest error"},
                      error, 1.9, 2.1);
}

TEST(Oscillation, energy_drift_has_order_2_with_variable_steps) {
  std::vector<double> drift;
  for (int level = 0; level < 4; ++level) drift.push_back(run(256 << level).energy_drift);
  claim::expect_order(
      {"M.9", "oscillating sphere, variable steps: drift of energy", "the dt^4 term's share of the error"},
      drift, 1.9, 2.1);
}
