// SPDX-License-Identifier: Apache-2.0
// The element bound of omega^2 with shared masses (M.10, M.15): against true limits, and over all shapes of
// triangles.
#include <gtest/gtest.h>

#include "closed_form/membrane.hpp"
#include "closed_form/stability.hpp"
#include "dense.hpp"
#include "membrane/driver_bag.hpp"
#include "membrane/passenger_bag.hpp"

using membrane::Compression;

namespace {

// Triangles with no node in common, reference = position.
membrane::Mesh random_triangles(int count) {
  scenes::Random random(7);
  membrane::Mesh mesh;
  mesh.nodes.resize(3, 3 * count);
  mesh.elements.resize(3, count);
  mesh.panel.assign(static_cast<std::size_t>(count), 0);
  for (int e = 0; e < count; ++e) {
    mesh.elements.col(e) << 3 * e, 3 * e + 1, 3 * e + 2;
    double base = 0.0, height = 0.0;
    while (!(base > 1e-5 && height > 1e-3 * base)) {
      base = 0.01 * std::abs(random());
      height = 0.01 * std::abs(random());
    }
    mesh.nodes.col(3 * e).setZero();
    mesh.nodes.col(3 * e + 1) << base, 0.0, 0.0;
    mesh.nodes.col(3 * e + 2) << 0.01 * random(), height, 0.0;
  }
  return mesh;
}

double smallest_altitude(const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return b[0] * c[1] / std::max({b.norm(), c.norm(), (c - b).norm()});
}

}  // namespace

// Fabric whose thickness and stiffness jump from element to element: shares differ most from own masses
// there.
TEST(MassShares, dense_eigenvalue_of_uneven_fabric_below_bound) {
  const auto mesh = membrane::icosphere(0.3, 1);
  for (const auto compression : {Compression::linear, Compression::none})
    for (const double amplitude : {0.0, 0.01, 0.1}) {
      auto d = scenes::describe(mesh, compression);
      d.fixed_nodes = {4};
      scenes::Random random(11);
      for (auto& p : d.properties) {
        p.thickness *= std::pow(2.0, random());
        p.young *= std::pow(10.0, random());
      }
      const auto model = make_model(d);
      const Eigen::Matrix3Xd x = scenes::shaken(1.05 * mesh.nodes, amplitude, 9);
      const double exact = scenes::greatest_frequency(
          model, x, [&](const Eigen::Matrix3Xd& at) { return scenes::membrane_force(model, at); });
      const double bound = scenes::evaluated(model, x).forces.element_frequency;
      // Differences: curvature h / side = 1e-6 of the stiffness.
      EXPECT_LE(exact, bound * (1.0 + 1e-5)) << amplitude;
      if (amplitude == 0.0) {
        EXPECT_GE(std::sqrt(exact / bound), 0.85);  // 0.56 if each element had its own mass only
      }
    }
}

// As sewn and swollen by 3 %. The step must stay below the limit and reach 0.8 of it.
TEST(MassShares, shipped_bags_reach_four_fifths_of_the_true_step) {
  const auto passenger = membrane::passenger_bag();
  const auto driver = membrane::driver_bag();
  const struct {
    const membrane::Mesh& mesh;
    const Eigen::Matrix3Xd& initial;
    std::vector<std::string> null_panels;
  } bags[] = {{passenger.mesh, passenger.mesh.nodes, {"vent"}},
              {driver.mesh, driver.opened, {"vent_left", "vent_right"}}};
  for (const auto& bag : bags) {
    const auto model = make_model(scenes::describe_shipped(bag.mesh, bag.null_panels));
    for (const double stretch : {1.0, 1.03}) {
      const Eigen::Matrix3Xd x = stretch * bag.initial;
      const double below = scenes::power_estimate(model, x);
      const double bound = scenes::evaluated(model, x).forces.element_frequency;
      EXPECT_LE(below, bound * (1.0 + 1e-5)) << stretch;
      EXPECT_GE(std::sqrt(below / bound), 0.8) << stretch;
    }
  }
}

// 60 000 free triangles: the bound is the triangle's own eigenvalue, and the step in units of h / c is never
// below sqrt(2/3) (needles) or sqrt(8 / (9 (1 + nu))) (equilateral), whichever is less.
TEST(MassShares, every_shape_of_triangle_eq_closed_form) {
  const auto mesh = random_triangles(60000);
  for (const double nu : {0.0, 0.3, 0.49}) {
    auto sheet = closed_form::paper_fabric();
    sheet.poisson_ratio = nu;
    auto d = scenes::describe(mesh, Compression::linear);
    for (auto& p : d.properties) p.poisson = nu;
    const auto model = make_model(d);
    const auto state = scenes::evaluated(model, mesh.nodes);
    const double c = closed_form::wave_speeds(sheet).plane;
    double least = 10.0, difference = 0.0;
    for (int e = 0; e < mesh.element_count(); ++e) {
      const Eigen::Vector3d tip = mesh.nodes.col(3 * e + 2), side = mesh.nodes.col(3 * e + 1);
      const double exact = closed_form::triangle_frequency(sheet, side[0], tip[0], tip[1]);
      const double bound = element_response(model, state, e).frequency;
      difference = std::max(difference, std::abs(std::sqrt(bound) / exact - 1.0));
      least = std::min(least, 2.0 / std::sqrt(bound) * c / smallest_altitude(side, tip));
    }
    // Two 3 x 3 eigenvalue routes, conditioned by (longest side / altitude)^2, 1e6 at most.
    EXPECT_LT(difference, 1e6 * 10 * scenes::kEps) << nu;
    const double worst = std::min(std::sqrt(2.0 / 3.0), std::sqrt(8.0 / (9.0 * (1.0 + nu))));
    EXPECT_GE(least, worst * (1.0 - 1e-9)) << nu;
    EXPECT_LE(least, worst * 1.01) << nu;  // so many shapes come this near to the worst
  }
}
