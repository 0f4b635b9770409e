// SPDX-License-Identifier: Apache-2.0
// Volume, its gradient and the areas (M.5, M.6).
#include <gtest/gtest.h>

#include <algorithm>

#include "claim.hpp"
#include "closed_form/membrane.hpp"
#include "scenes.hpp"

using membrane::BagModel;
using membrane::Compression;

namespace {

// Closed surfaces of size about 1 m: far from round, self-intersecting ones too (the identities are algebra).
struct Surface {
  BagModel model;
  Eigen::Matrix3Xd x;
};

std::vector<Surface> surfaces() {
  std::vector<Surface> list;
  for (const double amplitude : {0.0, 0.1, 1.0}) {
    const auto mesh = mesh::icosphere(0.7, 2);
    list.push_back(
        {make_model(scenes::describe(mesh, Compression::none)), scenes::shaken(mesh.nodes, amplitude, 11)});
  }
  return list;
}

double volume(const BagModel& model, const Eigen::Matrix3Xd& x) {
  auto state = membrane::make_state(model, x);
  membrane::update_surface(model, state);
  return state.surface.volume;
}

Eigen::Matrix3Xd gradient(const BagModel& model, const Eigen::Matrix3Xd& x) {
  auto state = membrane::make_state(model, x);
  membrane::update_surface(model, state);
  return state.volume_gradient.map();
}

// eps x (elements 320 x about 10 operations on terms of 1 m3 or 1 m2), worst case of the sums.
constexpr double kRound = 3200 * scenes::kEps;

}  // namespace

TEST(Surface, volume_gradient_identities) {
  for (const auto& [model, x] : surfaces()) {
    const Eigen::Matrix3Xd g = gradient(model, x);
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (Eigen::Index n = 0; n < x.cols(); ++n)
      moment += Eigen::Vector3d(x.col(n)).cross(Eigen::Vector3d(g.col(n)));
    EXPECT_LE(g.rowwise().sum().norm(), kRound);
    EXPECT_LE(moment.norm(), kRound);
    claim::expect_near(
        {"M.5", "closed surfaces, distorted: sum of x . dV/dx, 3 V [m3]", "3200 roundings of 1 m3"},
        x.cwiseProduct(g).sum(), 3.0 * volume(model, x), kRound);
  }
}

TEST(Surface, volume_is_linear_in_each_vertex) {
  for (const auto& [model, x] : surfaces()) {
    const Eigen::Matrix3Xd g = gradient(model, x);
    for (const Eigen::Index n : {0, 1, 40, 161})
      for (int c = 0; c < 3; ++c) {
        Eigen::Matrix3Xd moved = x;
        moved(c, n) += 0.3;
        EXPECT_NEAR(volume(model, moved) - volume(model, x), 0.3 * g(c, n), kRound);
      }
  }
}

TEST(Surface, volume_change_eq_simpson_rule) {
  for (const auto& [model, x] : surfaces()) {
    const Eigen::Matrix3Xd dx = 0.3 * scenes::Random(5).vectors(x.cols());
    const Eigen::Matrix3Xd end_gradients = gradient(model, x) + gradient(model, x + dx);
    const double change = 0.5 * end_gradients.cwiseProduct(dx).sum() - 0.5 * volume(model, dx);
    claim::expect_near(
        {"M.5", "closed surfaces: change of volume by Simpson's rule [m3]", "6400 roundings of 1 m3"},
        volume(model, x + dx) - volume(model, x), change, 2 * kRound);
  }
}

// On a grid of 2^-30 m every shift by whole metres below 2^20 is exact, so the volume must keep its very
// bits.
TEST(Surface, volume_independent_of_origin) {
  for (const auto& [model, x] : surfaces()) {
    const Eigen::Matrix3Xd grid = (x * 0x1p30).array().round() * 0x1p-30;
    for (const double far : {1.0, 1024.0, 1048572.0}) {
      const Eigen::Matrix3Xd moved = grid.colwise() + Eigen::Vector3d(far, -far, 0.5 * far);
      EXPECT_EQ(volume(model, moved), volume(model, grid));
    }
  }
}

TEST(Surface, icosahedron_volume_eq_closed_form) {
  const auto mesh = mesh::icosphere(1.0, 0);
  const auto model = make_model(scenes::describe(mesh, Compression::none));
  const double edge = (mesh.nodes.col(mesh.elements(0, 0)) - mesh.nodes.col(mesh.elements(1, 0))).norm();
  claim::expect_near({"M.5", "icosahedron: volume [m3]", "20 elements, 10 roundings each"},
                     volume(model, mesh.nodes), closed_form::icosahedron_volume(edge), 200 * scenes::kEps);
}

// V along a straight motion is a cubic in time, which the five-point difference derives exactly.
TEST(Surface, pressure_power_eq_p_dVdt) {
  const double pressure = 2e4, h = 0.1;
  for (const auto& [model, x] : surfaces()) {
    const Eigen::Matrix3Xd v = scenes::Random(3).vectors(x.cols());
    auto state = membrane::make_state(model, x);
    membrane::update_surface(model, state);
    membrane::pressure_forces(state, pressure);
    const double power = (state.gauge_pressure * state.volume_gradient.map().cwiseProduct(v)).sum();
    const auto at = [&](double t) { return volume(model, x + t * v); };
    const double rate = (8.0 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12.0 * h);
    claim::expect_near({"M.6", "closed surfaces: power of the pressure, p dV/dt [W]",
                        "3200 roundings of 1 m3, differences over 0.1 s"},
                       power, pressure * rate, pressure * kRound * 3.0 / h);
  }
}

TEST(Surface, areas_and_porous_sums_eq_direct_sums) {
  const auto mesh = mesh::icosphere(0.7, 2);
  auto description = scenes::describe(mesh, Compression::none);
  for (std::size_t e = 0; e < description.properties.size(); ++e)
    description.properties[e].porosity = 0.01 * static_cast<double>(e % 7);
  const auto model = make_model(description);
  const Eigen::Matrix3Xd x = scenes::shaken(mesh.nodes, 0.1, 2);
  auto state = membrane::make_state(model, x, {.jet = true});
  membrane::update_surface(model, state);
  membrane::update_geometry(model, state);
  const Eigen::VectorXd area = mesh::element_areas(x, mesh.elements);
  double first = 0.0, second = 0.0;
  for (Eigen::Index e = 0; e < area.size(); ++e) {
    const double eta = description.properties[static_cast<std::size_t>(e)].porosity;
    first += eta * area[e];
    second += eta * eta * area[e];
    EXPECT_NEAR(state.area_vector.map().col(e).norm(), area[e], 16 * scenes::kEps);
  }
  EXPECT_NEAR(state.surface.area, area.sum(), kRound);
  EXPECT_NEAR(state.surface.porosity_area, first, kRound);
  EXPECT_NEAR(state.surface.porosity_squared_area, second, kRound);
}

TEST(Surface, centroid_eq_plain_double_formula) {
  const auto mesh = mesh::icosphere(0.7, 1);
  const auto model = make_model(scenes::describe(mesh, Compression::none));
  const Eigen::Matrix3Xd x = scenes::shaken(mesh.nodes, 0.1, 2);
  auto state = membrane::make_state(model, x, {.jet = true});
  membrane::update_geometry(model, state);
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int c = 0; c < 3; ++c) {
      const double a = x(c, mesh.elements(0, e)), b = x(c, mesh.elements(1, e)),
                   d = x(c, mesh.elements(2, e));
      EXPECT_EQ(state.centroid.map()(c, e), ((a + b) + d) / 3.0);
    }
}

TEST(Surface, geometry_is_that_of_the_elements_asked_for) {
  const auto mesh = mesh::icosphere(0.7, 1);
  const auto model = make_model(scenes::describe(mesh, Compression::none));
  auto all = membrane::make_state(model, scenes::shaken(mesh.nodes, 0.1, 2), {.jet = true}), some = all;
  membrane::update_geometry(model, all);
  const std::vector<int> elements{79, 3, 40, 41, 7};
  membrane::update_geometry(model, some, elements);
  for (int e = 0; e < mesh.element_count(); ++e) {
    const bool asked = std::find(elements.begin(), elements.end(), e) != elements.end();
    EXPECT_EQ(some.area_vector.map().col(e), (asked ? 1.0 : 0.0) * all.area_vector.map().col(e));
    EXPECT_EQ(some.centroid.map().col(e), (asked ? 1.0 : 0.0) * all.centroid.map().col(e));
  }
}

// Each element's area vector is shared equally by its corners, null elements included.
TEST(Surface, jet_force_eq_overpressure_times_area_vector_third) {
  const auto mesh = mesh::icosphere(0.7, 1);
  auto description = scenes::describe(mesh, Compression::none);
  const auto model = make_model(description);
  const Eigen::Matrix3Xd x = scenes::shaken(mesh.nodes, 0.1, 2);
  auto state = scenes::evaluated(model, x, {.jet = true});
  std::vector<double> dp(static_cast<std::size_t>(mesh.element_count()));
  for (std::size_t e = 0; e < dp.size(); ++e) dp[e] = e % 3 == 0 ? 1000.0 + static_cast<double>(e) : 0.0;
  membrane::jet_forces(model, state, dp);
  Eigen::Matrix3Xd expected = Eigen::Matrix3Xd::Zero(3, x.cols());
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int k = 0; k < 3; ++k)
      expected.col(mesh.elements(k, e)) +=
          dp[static_cast<std::size_t>(e)] / 3.0 * state.area_vector.map().col(e);
  // Six corners a node, 1100 Pa x 0.02 m2 each.
  EXPECT_LE((state.jet_force.map() - expected).cwiseAbs().maxCoeff(), 6 * 4 * scenes::kEps * 22.0);
  // The same as two jets that load every other element, told which ones; what lies beside them is not read.
  const Eigen::Matrix3Xd one = state.jet_force.map();
  std::vector<int> even, odd;
  std::vector<double> even_dp(dp.size(), std::numeric_limits<double>::quiet_NaN()), odd_dp = even_dp;
  for (std::size_t e = 0; e < dp.size(); ++e) {
    (e % 2 == 0 ? even : odd).push_back(static_cast<int>(e));
    (e % 2 == 0 ? even_dp : odd_dp)[e] = dp[e];
  }
  const std::vector<membrane::JetLoad> loads{{even_dp, even}, {odd_dp, odd}};
  membrane::jet_forces(model, state, loads);
  EXPECT_LE((state.jet_force.map() - one).cwiseAbs().maxCoeff(), 6 * 4 * scenes::kEps * 22.0);
  // What another load left at other nodes is gone.
  const std::vector<int> one_element{9};
  membrane::jet_forces(model, state, std::vector<membrane::JetLoad>{{dp, one_element}});
  EXPECT_EQ((state.jet_force.map().colwise().norm().array() > 0.0).count(), 3);
  // A uniform overpressure is a pressure.
  std::fill(dp.begin(), dp.end(), 500.0);
  membrane::jet_forces(model, state, dp);
  EXPECT_LE((state.jet_force.map() - 500.0 * state.volume_gradient.map()).cwiseAbs().maxCoeff(),
            6 * 4 * scenes::kEps * 10.0);
}
