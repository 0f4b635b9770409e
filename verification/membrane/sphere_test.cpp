// SPDX-License-Identifier: Apache-2.0
// Sphere under pressure: mesh order of the equilibrium stretch, at small strain and at 7 %.
#include <gtest/gtest.h>

#include "claim.hpp"
#include "closed_form/membrane.hpp"
#include "statics.hpp"

using membrane::Compression;

namespace {

// Stretch (V / V_reference)^(1/3) of the icosphere of 0.3 m at rest under pressure.
double equilibrium_stretch(int level, double pressure) {
  const auto mesh = mesh::icosphere(0.3, level);
  const auto model = make_model(scenes::describe(mesh, Compression::none));
  auto state = membrane::make_state(model, (1.0 + 3.5e-6 * pressure) * mesh.nodes);
  // 1e-6 of the force of the pressure on a node: the stretch to 1e-6 of its strain.
  scenes::relax(model, state, pressure, 1e-6 * pressure * 1.13 / model.node_count);
  return std::cbrt(state.surface.volume / mesh::enclosed_volume(mesh.nodes, mesh.elements));
}

}  // namespace

// St. Venant-Kirchhoff; at 100 Pa the strain is that of the linear theory, q / 2 with q = p R (1 - nu) / (E
// h).
TEST(Sphere, stretch_converges_to_closed_form_with_order_2) {
  const closed_form::StretchedSphere sphere{closed_form::paper_fabric(), 0.3};
  const double linear = 0.5 * 100.0 * 0.3 * 0.7 / (60e6 * 0.5e-3);
  EXPECT_NEAR(closed_form::stretched_sphere(sphere, 100.0).stretch - 1.0, linear, linear * linear);
  for (const double pressure : {100.0, 2e4}) {
    const double exact = closed_form::stretched_sphere(sphere, pressure).stretch;
    std::vector<double> error;
    for (const int level : {1, 2, 3})
      error.push_back((equilibrium_stretch(level, pressure) - exact) / (exact - 1.0));
    claim::expect_order(
        {"M.2", pressure > 1e3 ? "sphere under 20 kPa: stretch" : "sphere under 100 Pa: stretch",
         "sides of an icosphere vary by 10 %, the first level is coarse"},
        error, 1.8, 2.2);
    EXPECT_LT(std::abs(error.back()), 0.02);  // 1280 elements: 11 / 1280 in volume and area
  }
}
