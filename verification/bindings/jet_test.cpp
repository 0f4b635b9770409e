// SPDX-License-Identifier: Apache-2.0
// Jet and hidden elements through gasjet.h.
#include <algorithm>
#include <chrono>
#include <cstring>
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

/// `mesh` among nodes of other parts, which stand before and between its own and hold anything.
struct PartOfModel {
  Mesh whole;
  explicit PartOfModel(const Mesh& mesh, double others) {
    const auto count = static_cast<std::size_t>(mesh.node_count());
    for (std::size_t i = 0; i < count; ++i) {
      whole.nodes.insert(whole.nodes.end(), 9, others);
      std::copy_n(mesh.nodes.data() + 3 * i, 3, whole.nodes.end() - 6);
    }
    for (const int32_t node : mesh.triangles) whole.triangles.push_back(3 * node + 1);
  }
};

TEST(c_jet, nodes_of_no_triangle_change_nothing) {
  const Mesh mesh = nested();
  const auto elements = static_cast<std::size_t>(mesh.triangle_count());
  gasjet_jet_model model = round_jet();
  model.axis[1] = 0.5;
  const gasjet_source source{{0.01, 0.02, 0.03}, {1.0, 0.5, 0.2}, {0.0, 0.0, 0.0}, 0.0};
  const auto answers = [&](const Mesh& of, const Layout& layout) {
    Handle jet, surface;
    EXPECT_OK(gasjet_jet_create(&model, of.triangles.data(), of.triangle_count(), nullptr, of.node_count(),
                                nullptr, 0, nullptr, 0, &jet.value));
    EXPECT_OK(gasjet_surface_create(of.triangles.data(), of.triangle_count(), nullptr, of.node_count(),
                                    nullptr, 0, nullptr, 0, &surface.value));
    std::vector<double> all(elements + 3);
    std::vector<uint8_t> lit(elements);
    const double* nodes = layout.data.data() + layout.first;
    EXPECT_OK(gasjet_jet_pressure(jet.value, nodes, of.node_count(), layout.stride, 400.0, 1.0, 1, kNan,
                                  all.data(), of.triangle_count(), all.data() + elements, nullptr));
    EXPECT_OK(gasjet_surface_visible(surface.value, nodes, of.node_count(), layout.stride, &source, nullptr,
                                     0, kNan, lit.data(), of.triangle_count(), nullptr));
    all.insert(all.end(), lit.begin(), lit.end());
    return all;
  };
  const auto alone = answers(mesh, layouts_of(mesh.nodes).front());
  for (const double others : {0.0, 1e-150, 1e300, kInfinity, kNan}) {
    const PartOfModel part(mesh, others);
    for (const Layout& layout : layouts_of(part.whole.nodes)) EXPECT_EQ(answers(part.whole, layout), alone);
  }
}

TEST(c_jet, a_coordinate_is_refused_by_the_callers_number) {
  const PartOfModel part(box(2, 2.0, -1.0), kNan);
  const gasjet_jet_model model = round_jet();
  Handle jet;
  ASSERT_OK(gasjet_jet_create(&model, part.whole.triangles.data(), part.whole.triangle_count(), nullptr,
                              part.whole.node_count(), nullptr, 0, nullptr, 0, &jet.value));
  std::vector<double> pressure(static_cast<std::size_t>(part.whole.triangle_count()));
  double force[3];
  for (const auto& [bad, words] : {std::pair{kNan, "row 13 that is not finite"}, {1e-150, "node 13 has"}}) {
    auto nodes = part.whole.nodes;
    nodes[3 * 13 + 2] = bad;
    EXPECT_EQ(gasjet_jet_pressure(jet.value, nodes.data(), part.whole.node_count(), nullptr, 400.0, 1.0, 1,
                                  kNan, pressure.data(), part.whole.triangle_count(), force, nullptr),
              GASJET_BAD_INPUT);
    EXPECT_NE(std::string(gasjet_last_error()).find(words), std::string::npos) << gasjet_last_error();
  }
}

/// Allowed: five times the time of the bag alone; reading them all takes some 150 times as long.
TEST(c_jet, a_million_nodes_of_other_parts_cost_a_call_nothing) {
  const Mesh mesh = nested();
  Mesh large = mesh;
  large.nodes.resize(3'000'000, kNan);
  const gasjet_jet_model model = round_jet();
  std::vector<double> pressure(static_cast<std::size_t>(mesh.triangle_count()));
  const auto fastest_call = [&](const Mesh& of) {
    Handle jet;
    EXPECT_OK(gasjet_jet_create(&model, of.triangles.data(), of.triangle_count(), nullptr, of.node_count(),
                                nullptr, 0, nullptr, 0, &jet.value));
    double force[3], fastest = kInfinity;
    for (int i = 0; i < 50; ++i) {
      const auto begin = std::chrono::steady_clock::now();
      EXPECT_OK(gasjet_jet_pressure(jet.value, of.nodes.data(), of.node_count(), nullptr, 400.0, 1.0, 1, kNan,
                                    pressure.data(), of.triangle_count(), force, nullptr));
      const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
      fastest = std::min(fastest, taken.count());
    }
    return fastest;
  };
  const double alone = fastest_call(mesh), among = fastest_call(large);
  RecordProperty("alone_us", std::to_string(1e6 * alone));
  RecordProperty("among_us", std::to_string(1e6 * among));
  EXPECT_LT(among, 5.0 * alone) << among << " s among a million nodes, " << alone << " s alone";
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

/// The same for an outlet at 2.3 times the pressure around it: mdot V0 + (pe - p) A + e mdot V0.
TEST(c_jet, expanded_jet_on_a_wall_eq_thrust_and_what_is_turned_back) {
  const Mesh mesh = box(160, 1.0, -0.5);
  gasjet_jet_model model = round_jet();
  model.centre[0] = -0.2;
  Handle jet;
  ASSERT_OK(gasjet_jet_create(&model, mesh.triangles.data(), mesh.triangle_count(), nullptr,
                              mesh.node_count(), nullptr, 0, nullptr, 0, &jet.value));
  const double area = std::acos(-1.0) * model.radius * model.radius, p = 101325.0;
  gasjet_outlet_state sonic, nozzle;
  ASSERT_OK(gasjet_outlet(GASJET_SONIC_STAGNATION, area, 1.0, 500.0, 1038.8, 296.8, p, &sonic));
  ASSERT_OK(gasjet_outlet(GASJET_EXPANDED, area, 1.0, 500.0, 1038.8, 296.8, p, &nozzle));
  EXPECT_EQ(nozzle.pressure, p);
  const double thrust = sonic.velocity + (sonic.pressure - p) * area;  // mass flow 1 kg/s
  EXPECT_GT(sonic.pressure, 2.0 * p);
  EXPECT_NEAR(nozzle.velocity, thrust, 1e-13 * thrust);
  std::vector<double> pressure(static_cast<std::size_t>(mesh.triangle_count()));
  const auto force_on_wall = [&] {
    double force[3];
    EXPECT_OK(gasjet_jet_pressure(jet.value, mesh.nodes.data(), mesh.node_count(), nullptr, nozzle.velocity,
                                  nozzle.density, 1, 0.0, pressure.data(), mesh.triangle_count(), force,
                                  nullptr));
    return force[0];
  };
  const double before = force_on_wall();
  const double area_ratio = 1.0 / (nozzle.density * nozzle.velocity * area);
  for (const double e : {-0.5, 0.0, 0.3, 1.0, 4.0, kNan}) {
    ASSERT_OK(gasjet_jet_expansion(jet.value, area_ratio, sonic.velocity / nozzle.velocity, e));
    const double exact = thrust + (std::isnan(e) ? 4.0 : e) * sonic.velocity;  // NaN: as it was
    EXPECT_NEAR(force_on_wall(), exact, 3e-3 * exact);
  }
  ASSERT_OK(gasjet_jet_expansion(jet.value, 1.0, 1.0, 1.0));
  EXPECT_EQ(force_on_wall(), before);
}

TEST(c_jet, expanded_outlet_below_bag_pressure_is_the_matched_one) {
  gasjet_outlet_state expanded, matched;
  for (const double p : {1e5, 2e5}) {
    ASSERT_OK(gasjet_outlet(GASJET_EXPANDED, 1e-2, 1.0, 500.0, 1038.8, 296.8, p, &expanded));
    ASSERT_OK(gasjet_outlet(GASJET_PRESSURE_MATCHED, 1e-2, 1.0, 500.0, 1038.8, 296.8, p, &matched));
    EXPECT_EQ(std::memcmp(&expanded, &matched, sizeof expanded), 0);
  }
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
