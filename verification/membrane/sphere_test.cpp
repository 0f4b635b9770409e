// SPDX-License-Identifier: Apache-2.0
// St. Venant-Kirchhoff sphere under pressure: mesh order of the equilibrium stretch.
#include <gtest/gtest.h>

#include <cmath>

#include "closed_form/membrane.hpp"
#include "scenes.hpp"

using membrane::Compression;

namespace {

constexpr double kPressure = 2e4;  // [Pa]

// Stretch (V / V_reference)^(1/3) of the icosphere at rest under pressure, by damped motion.
double equilibrium_stretch(int level) {
  const auto mesh = membrane::icosphere(0.3, level);
  auto d = scenes::describe(mesh, Compression::none);
  d.mass_damping = 700.0;  // critical for the slow shape modes, sqrt(S / rho) / R = 350 rad/s
  const auto model = make_model(d);
  auto state = membrane::make_state(model, 1.07 * mesh.nodes);
  double dt = 0.0;
  for (double time = 0.0; time < 0.1; time += dt) {
    membrane::update_surface(model, state);
    membrane::membrane_forces(model, state);
    membrane::pressure_forces(state, kPressure);
    const double before = dt;
    dt = 0.9 * membrane::critical_time_step(membrane::stiffness_shares(model, state, 0.0, kPressure));
    membrane::advance(model, state, before, dt);
  }
  // Left after 35 decay times: below the square of the mesh error by far.
  EXPECT_LT(state.advance.kinetic_after, 1e-12 * state.forces.strain_energy);
  membrane::update_surface(model, state);
  return std::cbrt(state.surface.volume / membrane::enclosed_volume(mesh.nodes, mesh.elements));
}

}  // namespace

TEST(Sphere, stretch_converges_to_closed_form_with_order_2) {
  const double exact = closed_form::stretched_sphere({closed_form::paper_fabric(), 0.3}, kPressure).stretch;
  double error[3];
  for (int level = 1; level <= 3; ++level) error[level - 1] = equilibrium_stretch(level) - exact;
  for (int i = 0; i < 2; ++i) {
    const double order = std::log2(error[i] / error[i + 1]);
    EXPECT_GT(order, 1.8) << i;  // sides of an icosphere vary by 10 %, the first level is coarse
    EXPECT_LT(order, 2.2) << i;
  }
  EXPECT_LT(std::abs(error[2]), 5e-3 * (exact - 1.0) * 4.0);
}
