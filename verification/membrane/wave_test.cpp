// SPDX-License-Identifier: Apache-2.0
// Plane waves on a sheet: speeds and the discrete dispersion relation.
#include <gtest/gtest.h>

#include <numbers>

#include "claim.hpp"
#include "closed_form/membrane.hpp"
#include "scenes.hpp"

using membrane::Compression;

namespace {

constexpr double kWaveSide = 0.64;  // [m]

struct Wave {
  const char* name;
  double stretch;             // of the reference along x
  Eigen::Vector3d direction;  // of the displacement
  double speed;               // referential [m/s]
};

std::vector<Wave> waves() {
  const auto sheet = closed_form::paper_fabric();
  const auto speeds = closed_form::wave_speeds(sheet);
  const auto stretched = closed_form::stretched_wave_speeds(sheet, 1.1);
  return {{"plane", 1.0, {1, 0, 0}, speeds.plane},
          {"shear", 1.0, {0, 1, 0}, speeds.shear},
          {"stretched longitudinal", 1.1, {1, 0, 0}, stretched.longitudinal},
          {"stretched transverse", 1.1, {0, 0, 1}, stretched.transverse}};
}

// Height of the standing wave A cos(k x) at the middle node after `steps` steps from rest, over A. One step
// carries a disturbance one cell, so the free edges (cells / 2 away) are not felt.
double height_after(const Wave& wave, int cells, double wave_number, double dt, int steps) {
  const auto mesh = mesh::rectangle(cells, cells, kWaveSide, kWaveSide, mesh::Diagonals::uniform);
  const auto model = make_model(scenes::describe(mesh, Compression::linear));
  const int middle = cells / 2 * (cells + 1) + cells / 2;
  const double x0 = mesh.nodes(0, middle), amplitude = 1e-7;
  Eigen::Matrix3Xd x = mesh.nodes;
  x.row(0) *= wave.stretch;
  const Eigen::Vector3d at_rest = x.col(middle);
  for (int n = 0; n < mesh.node_count(); ++n)
    x.col(n) += amplitude * std::cos(wave_number * (mesh.nodes(0, n) - x0)) * wave.direction;
  auto state = membrane::make_state(model, x);
  for (int i = 0; i < steps; ++i) {
    membrane::membrane_forces(model, state);
    membrane::advance(model, state, i == 0 ? 0.0 : dt, dt);
  }
  const double now = (state.position.map().col(middle) - at_rest).dot(wave.direction);
  return now / amplitude;
}

}  // namespace

// sin(omega dt / 2) = (c dt / h) sin(k h / 2) exactly, in every direction of displacement.
TEST(Wave, frequency_eq_discrete_dispersion_relation) {
  const int cells = 32, steps = 14;
  const double h = kWaveSide / cells;
  for (const auto& wave : waves())
    for (const double waves_on_side : {2.0, 5.0, 8.0}) {
      SCOPED_TRACE(wave.name);
      const double k = 2.0 * std::numbers::pi * waves_on_side / kWaveSide;
      const double dt = 0.35 * h / std::max(wave.speed, waves()[2].speed);
      const double exact = 2.0 / dt * std::asin(wave.speed * dt / h * std::sin(0.5 * k * h));
      claim::expect_near(
          {"M.9", std::string(wave.name) + " wave on a lattice: height over amplitude after 14 steps",
           "eps x 0.7 m / A = 2e-9; stretched waves are non-linear by (A k)^2, A k = 1e-5"},
          height_after(wave, cells, k, dt, steps), std::cos(exact * steps * dt), 1e-7);
    }
}

TEST(Wave, speed_converges_with_order_2) {
  const double k = 2.0 * std::numbers::pi * 2.0 / kWaveSide;
  for (const auto& wave : waves()) {
    SCOPED_TRACE(wave.name);
    std::vector<double> error;
    for (int level = 0; level < 3; ++level) {
      const int cells = 16 << level;
      const double dt = 0.35 * kWaveSide / cells / waves()[2].speed;
      const int steps = 7 << level;
      const double frequency = std::acos(height_after(wave, cells, k, dt, steps)) / (steps * dt);
      error.push_back(1.0 - frequency / (wave.speed * k));
    }
    claim::expect_order({"M.4", std::string(wave.name) + " wave: speed",
                         "the next term is of the order of (k h)^2 of the first"},
                        error, 1.9, 2.1);
  }
}
