// SPDX-License-Identifier: Apache-2.0
// Jet and hidden elements through gasjet.h.
#include <numeric>

#include "jet/visibility.hpp"
#include "meshes.hpp"

using namespace border_test;

namespace {

/// A big box with a small one inside, turned inside out, which hides part of it.
Mesh nested() {
  Mesh mesh = box(6, 2.0, -1.0), inner = box(2, 0.4, 0.2);
  const auto first = static_cast<int32_t>(mesh.node_count());
  mesh.nodes.insert(mesh.nodes.end(), inner.nodes.begin(), inner.nodes.end());
  for (std::size_t e = 0; e < inner.triangles.size(); e += 3)
    for (const std::size_t k : {0, 2, 1}) mesh.triangles.push_back(first + inner.triangles[e + k]);
  return mesh;
}

std::vector<uint8_t> library_mask(const Mesh& mesh, const jet::RaySource& source) {
  return jet::visible(Eigen::Map<const Eigen::Matrix3Xd>(mesh.nodes.data(), 3, mesh.node_count()),
                      Eigen::Map<const Eigen::Matrix3Xi>(mesh.triangles.data(), 3, mesh.triangle_count()),
                      source, jet::VisibilityRoute::brute_force);
}

TEST(c_surface, mask_eq_the_librarys_in_every_layout) {
  const Mesh mesh = nested();
  const auto elements = static_cast<std::size_t>(mesh.triangle_count());
  const gasjet_source source{{0.01, 0.02, 0.03}, {1.0, 0.5, 0.2}, {0.0, 0.0, 0.0}, 0.0};
  const auto exact = library_mask(mesh, {{0.01, 0.02, 0.03}, {1.0, 0.5, 0.2}, {0.0, 0.0, 0.0}, 0.0});
  Handle surface;
  ASSERT_OK(gasjet_surface_create(mesh.triangles.data(), mesh.triangle_count(), nullptr, mesh.node_count(),
                                  nullptr, 0, nullptr, 0, &surface.value));
  for (const Layout& layout : layouts_of(mesh.nodes)) {
    std::vector<uint8_t> lit(elements, 7);
    gasjet_visibility counters;
    ASSERT_OK(gasjet_surface_visible(surface.value, layout.data.data() + layout.first, mesh.node_count(),
                                     layout.stride, &source, nullptr, 0, kNan, lit.data(),
                                     mesh.triangle_count(), &counters));
    EXPECT_EQ(lit, exact);
    EXPECT_EQ(counters.candidates, mesh.triangle_count());
    EXPECT_EQ(counters.lit, std::accumulate(lit.begin(), lit.end(), 0));
    EXPECT_GT(counters.hidden, 20);
    EXPECT_EQ(counters.lit + counters.hidden + counters.facing_away, counters.candidates);
  }
  const int32_t some[] = {5, 3, 60};
  uint8_t lit[3];
  ASSERT_OK(gasjet_surface_visible(surface.value, mesh.nodes.data(), mesh.node_count(), nullptr, &source,
                                   some, 3, kNan, lit, 3, nullptr));
  for (int k = 0; k < 3; ++k) EXPECT_EQ(lit[k], exact[static_cast<std::size_t>(some[k])]);
}

TEST(c_surface, triangles_of_fortran_order_eq_rows) {
  const Mesh mesh = nested();
  const int64_t count = mesh.triangle_count();
  std::vector<int32_t> columns(mesh.triangles.size());
  for (int64_t e = 0; e < count; ++e)
    for (int64_t k = 0; k < 3; ++k)
      columns[static_cast<std::size_t>(e + k * count)] = mesh.triangles[static_cast<std::size_t>(3 * e + k)];
  const int64_t stride[] = {1, count};
  const gasjet_source source{{0.0, 0.1, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.05};
  Handle surface;
  ASSERT_OK(gasjet_surface_create(columns.data(), count, stride, mesh.node_count(), nullptr, 0, nullptr, 0,
                                  &surface.value));
  std::vector<uint8_t> lit(static_cast<std::size_t>(count));
  ASSERT_OK(gasjet_surface_visible(surface.value, mesh.nodes.data(), mesh.node_count(), nullptr, &source,
                                   nullptr, 0, kNan, lit.data(), count, nullptr));
  EXPECT_EQ(lit, library_mask(mesh, {{0.0, 0.1, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.05}));
}

/// Momentum of a jet that meets a wall at right angles: (1 + e) rho0 V0^2 A, less the cut-off's share.
TEST(c_jet, force_on_a_wall_eq_twice_the_momentum_flux) {
  const Mesh mesh = box(160, 1.0, -0.5);
  gasjet_jet_model model = round_jet();
  model.centre[0] = -0.2;
  Handle jet;
  ASSERT_OK(gasjet_jet_create(&model, mesh.triangles.data(), mesh.triangle_count(), nullptr,
                              mesh.node_count(), nullptr, 0, nullptr, 0, &jet.value));
  gasjet_outlet_state outlet;
  const double area = std::acos(-1.0) * model.radius * model.radius;
  ASSERT_OK(gasjet_outlet(GASJET_SONIC_STATIC, area, 1.0, 500.0, 1038.8, 296.8, 0.0, &outlet));
  EXPECT_NEAR(outlet.velocity, std::sqrt(1.4 * 296.8 * 500.0), 1e-10);
  std::vector<double> pressure(static_cast<std::size_t>(mesh.triangle_count()));
  double force[3];
  gasjet_visibility counters;
  ASSERT_OK(gasjet_jet_pressure(jet.value, mesh.nodes.data(), mesh.node_count(), nullptr, outlet.velocity,
                                outlet.density, 1, kNan, pressure.data(), mesh.triangle_count(), force,
                                &counters));
  const double exact = 2.0 * outlet.velocity;  // mass flow 1 kg/s
  EXPECT_NEAR(force[0], exact, 3e-3 * exact);  // cut-off 1e-3, and elements of 6 mm in a jet 70 mm wide
  EXPECT_NEAR(force[1], 0.0, 1e-9 * exact);
  EXPECT_EQ(counters.hidden, 0);
  EXPECT_GT(counters.lit, 500);
}

TEST(c_jet, what_stands_before_hides_what_is_behind) {
  const Mesh mesh = nested();
  gasjet_jet_model model = round_jet();
  model.axis[0] = model.axis[1] = model.axis[2] = 1.0;
  Handle jet;
  ASSERT_OK(gasjet_jet_create(&model, mesh.triangles.data(), mesh.triangle_count(), nullptr,
                              mesh.node_count(), nullptr, 0, nullptr, 0, &jet.value));
  std::vector<double> with(static_cast<std::size_t>(mesh.triangle_count())), without(with.size());
  double force[3], more[3];
  gasjet_visibility counters;
  ASSERT_OK(gasjet_jet_pressure(jet.value, mesh.nodes.data(), mesh.node_count(), nullptr, 400.0, 1.0, 1, kNan,
                                with.data(), mesh.triangle_count(), force, &counters));
  EXPECT_GT(counters.hidden, 0);
  ASSERT_OK(gasjet_jet_pressure(jet.value, mesh.nodes.data(), mesh.node_count(), nullptr, 400.0, 1.0, 0, kNan,
                                without.data(), mesh.triangle_count(), more, nullptr));
  int64_t darker = 0;
  for (std::size_t e = 0; e < with.size(); ++e) {
    EXPECT_TRUE(with[e] == 0.0 || with[e] == without[e]);
    darker += with[e] == 0.0 && without[e] > 0.0;
  }
  EXPECT_EQ(darker, counters.hidden);
}

TEST(c_jet, velocity_on_the_axis_eq_the_decay_law) {
  const gasjet_jet_model model = round_jet();
  const double points[] = {0.1, 0.0, 0.0, 1.0, 0.0, 0.0, -0.1, 0.0, 0.0};
  double velocity[9];
  ASSERT_OK(gasjet_jet_velocity(&model, points, 3, nullptr, velocity, 9));
  EXPECT_DOUBLE_EQ(velocity[0], 1.0);  // core: 0.67 radii / 0.08 = 0.1675 m
  EXPECT_NEAR(velocity[3], 0.96 / (0.08 * 1.0 / 0.02 + 0.29), 1e-14);
  EXPECT_EQ(velocity[6], 0.0);
}

}  // namespace
