// SPDX-License-Identifier: Apache-2.0
// The bound of the assembled fabric (M.15) against true limits, and both bounds over all shapes of triangles.
#include <gtest/gtest.h>

#include "closed_form/membrane.hpp"
#include "closed_form/stability.hpp"
#include "dense.hpp"
#include "membrane/passenger_bag.hpp"

using membrane::Compression;

namespace {

// Rayleigh quotient of M^-1/2 K M^-1/2 after some power steps, K by differences of the fabric's force: below
// the greatest omega^2, and some percent off it at most.
double power_estimate(const membrane::BagModel& model, const Eigen::Matrix3Xd& x) {
  const Eigen::Map<const Eigen::RowVectorXd> inverse_mass(model.inverse_mass.data(), model.node_count);
  const Eigen::RowVectorXd mobility = inverse_mass.cwiseSqrt();
  const double h = 1e-7;
  Eigen::Matrix3Xd u = scenes::Random(5).vectors(x.cols()), image;
  double quotient = 0.0;
  for (int i = 0; i < 300; ++i) {
    u /= u.norm();
    const Eigen::Matrix3Xd v = (h * u.array()).rowwise() * mobility.array();
    image = (scenes::membrane_force(model, x - v) - scenes::membrane_force(model, x + v)) / (2.0 * h);
    image.array().rowwise() *= mobility.array();
    quotient = u.cwiseProduct(image).sum();
    u = image;
  }
  return quotient;
}

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

// No folded, stretched or crumpled state of a small bag is above the bound.
TEST(AssembledBound, dense_eigenvalue_below_bound) {
  for (const int level : {0, 1})
    for (const auto compression : {Compression::linear, Compression::none})
      for (const double amplitude : {0.0, 0.01, 0.1}) {
        const auto mesh = membrane::icosphere(0.3, level);
        auto d = scenes::describe(mesh, compression);
        d.fixed_nodes = {4};
        const auto model = make_model(d);
        const Eigen::Matrix3Xd x = scenes::shaken(1.05 * mesh.nodes, amplitude, 9);
        const double exact = scenes::greatest_frequency(
            model, x, [&](const Eigen::Matrix3Xd& at) { return scenes::membrane_force(model, at); });
        const double bound = assembled_frequency(model, scenes::evaluated(model, x));
        // Differences: curvature h / side = 1e-6 of the stiffness.
        EXPECT_LE(exact, bound * (1.0 + 1e-5)) << level << ' ' << amplitude;
        if (amplitude == 0.0) {
          EXPECT_GE(std::sqrt(exact / bound), 0.87) << level;
        }
      }
}

// The gas adds to it as to the bound of the elements; the true limit has the pressure's load stiffness too.
TEST(AssembledBound, sum_with_gas_above_true_limit) {
  constexpr double gamma = 1.4, pressure = 121325.0, ambient = 101325.0;
  for (const int level : {0, 1})
    for (const double stretch : {1.02, 1.1, 1.25}) {
      const auto mesh = membrane::icosphere(0.3, level);
      const auto model = make_model(scenes::describe(mesh, Compression::none));
      const Eigen::Matrix3Xd x = stretch * mesh.nodes;
      const auto base = scenes::evaluated(model, x);
      const double exact = scenes::greatest_frequency(model, x, [&](const Eigen::Matrix3Xd& at) {
        const auto state = scenes::evaluated(model, at);
        const double p = pressure * std::pow(base.surface.volume / state.surface.volume, gamma);
        return Eigen::Matrix3Xd(state.membrane_force.map() + (p - ambient) * state.volume_gradient.map());
      });
      auto shares = membrane::stiffness_shares(model, base, gamma, pressure);
      shares.element = assembled_frequency(model, base);
      EXPECT_LE(exact, shares.total() * (1.0 + 1e-5)) << level << ' ' << stretch;
      // On so coarse a bag the gas is a tenth to a half of the sum, in a mode of its own.
      EXPECT_GE(std::sqrt(exact / shares.total()), 0.8) << level << ' ' << stretch;
    }
}

TEST(AssembledBound, passenger_bag_is_within_a_fifth_of_the_true_limit) {
  const auto bag = membrane::passenger_bag();
  auto d = scenes::describe(bag.mesh, Compression::linear);
  d.fixed_nodes = membrane::panel_nodes(bag.mesh, "attachment");
  const auto model = make_model(d);
  for (const double stretch : {1.0, 1.03}) {
    const Eigen::Matrix3Xd x = stretch * bag.mesh.nodes;
    const auto state = scenes::evaluated(model, x);
    const double below = power_estimate(model, x), bound = assembled_frequency(model, state);
    EXPECT_LE(below, bound * (1.0 + 1e-5));
    EXPECT_GE(std::sqrt(below / bound), 0.8);
    EXPECT_LT(bound, state.forces.element_frequency);
  }
}

// 60 000 shapes: both bounds are the triangle's own eigenvalue, and the step in units of h / c is never below
// sqrt(2/3) (needles) or sqrt(8 / (9 (1 + nu))) (equilateral), whichever is less.
TEST(AssembledBound, every_shape_of_triangle_eq_closed_form) {
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
