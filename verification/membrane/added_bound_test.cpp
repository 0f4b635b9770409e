// SPDX-License-Identifier: Apache-2.0
// Stiffnesses of gas, straps and plates, and their sum (M.11, M.12).
#include <gtest/gtest.h>

#include <numbers>

#include "bags.hpp"
#include "claim.hpp"
#include "closed_form/stability.hpp"
#include "dense.hpp"
#include "membrane/error.hpp"

using membrane::Compression;
using scenes::kAmbient;
using scenes::kGamma;

namespace {

constexpr double kPressure = 121325.0;

membrane::StiffnessShares shares_at(const membrane::BagModel& model, const Eigen::Matrix3Xd& x) {
  return membrane::stiffness_shares(model, scenes::evaluated(model, x), kGamma, kPressure);
}

}  // namespace

TEST(AddedBound, gas_share_converges_to_breathing_frequency) {
  std::vector<double> error;
  for (int level = 2; level <= 4; ++level) {
    const auto mesh = mesh::icosphere(0.3, level);
    const auto model = make_model(scenes::describe(mesh, Compression::none));
    const double exact = 3.0 * kGamma * kPressure / (0.3 * 620.0 * 0.5e-3);  // 3 gamma p / (R rho h)
    error.push_back(shares_at(model, mesh.nodes).gas / exact - 1.0);
  }
  EXPECT_LT(std::abs(error.back()), 5e-3);
  claim::expect_order(
      {"M.11", "gas stiffness of a sphere, 3 gamma p / (R rho h)", "geometry of the icosphere"}, error, 1.9,
      2.1);
}

// p = p_0 (V_0 / V)^gamma: the force's derivative is the gas stiffness (rank one) and the load stiffness -p_g
// d2V/dx2.
TEST(AddedBound, sum_is_above_true_limit_of_a_gas_filled_bag) {
  for (const int level : {0, 1}) {
    const auto mesh = mesh::icosphere(0.3, level);
    const auto model = make_model(scenes::describe(mesh, Compression::none));
    const Eigen::Matrix3Xd x = scenes::shaken(1.08 * mesh.nodes, 0.002, 6);
    const auto base = scenes::evaluated(model, x);
    const double exact = scenes::greatest_frequency(model, x, [&](const Eigen::Matrix3Xd& at) {
      const auto state = scenes::evaluated(model, at);
      const double p = kPressure * std::pow(base.surface.volume / state.surface.volume, kGamma);
      return Eigen::Matrix3Xd(state.membrane_force.map() + (p - kAmbient) * state.volume_gradient.map());
    });
    const double total = membrane::stiffness_shares(model, base, kGamma, kPressure).total();
    EXPECT_LE(exact, total * (1.0 + 1e-5));
    // Single elements of so coarse a bag: 0.70 to 0.8 of the true step.
    EXPECT_GE(std::sqrt(exact / total), 0.7);
  }
}

TEST(AddedBound, gas_share_eq_dense_eigenvalue_of_rank_one_stiffness) {
  auto d = scenes::describe(mesh::icosphere(0.3, 1), Compression::none);
  d.fixed_nodes = {0, 7};
  d.held_nodes = {{{3, 4}, {4}, {5, 6}}};
  const auto model = make_model(d);
  const Eigen::Matrix3Xd x = scenes::shaken(d.reference, 0.01, 6);
  const auto base = scenes::evaluated(model, x);
  const Eigen::Matrix3Xd g = base.volume_gradient.map();
  const double exact = scenes::greatest_frequency(model, x, [&](const Eigen::Matrix3Xd& at) {
    const double dp = -kGamma * kPressure / base.surface.volume * g.cwiseProduct(at - x).sum();
    return Eigen::Matrix3Xd(dp * g);
  });
  const double share = membrane::stiffness_shares(model, base, kGamma, kPressure).gas;
  claim::expect_relative({"M.11", "gas stiffness of a distorted sphere against its dense eigenvalue [1/s2]",
                          "rounding of the difference of forces, eps x 0.3 m / h"},
                         share, exact, 1e-7);
}

TEST(AddedBound, strap_share_above_dense_eigenvalue) {
  auto d = scenes::describe(mesh::icosphere(0.3, 1), Compression::none);
  d.straps = {{0, 20, 4500.0, 0.2}, {0, 30, 4500.0, 0.25}, {20, 40, 9000.0, 0.1}};
  for (const bool fixed : {false, true}) {
    if (fixed) d.fixed_nodes = {0};
    const auto model = make_model(d);
    const double exact = scenes::greatest_frequency(model, d.reference, [&](const Eigen::Matrix3Xd& at) {
      return Eigen::Matrix3Xd(scenes::evaluated(model, at).support_force.map());
    });
    EXPECT_LE(exact, model.strap_frequency * (1.0 + 1e-5));
    EXPECT_GE(exact, 0.5 * model.strap_frequency);
  }
}

TEST(AddedBound, plate_share_eq_dense_eigenvalue) {
  auto d = scenes::describe(mesh::icosphere(0.3, 1), Compression::none);
  d.plates = {{{-1.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}, 1e6}};  // all nodes behind it
  const auto model = make_model(d);
  const double exact = scenes::greatest_frequency(model, d.reference, [&](const Eigen::Matrix3Xd& at) {
    return Eigen::Matrix3Xd(scenes::evaluated(model, at).support_force.map());
  });
  EXPECT_NEAR(model.plate_frequency / exact, 1.0, 1e-7);
  EXPECT_NEAR(model.plate_frequency, 1e6 / (620.0 * 0.5e-3), 1e-9 * model.plate_frequency);
}

TEST(AddedBound, critical_step_adds_all_shares) {
  const membrane::StiffnessShares shares{1e8, 2e8, 3e8, 4e8, 6e8};
  EXPECT_EQ(membrane::critical_time_step(shares), 2.0 / std::sqrt(1.6e9));
  EXPECT_THROW(membrane::critical_time_step({}), membrane::MembraneError);
  for (const double bad : {-1.0, std::nan("")}) {
    EXPECT_THROW(membrane::critical_time_step(shares, bad), std::invalid_argument);
    EXPECT_THROW(membrane::critical_time_step({.element = 1e8, .damping = bad}), std::invalid_argument);
  }
}

TEST(AddedBound, gas_without_volume_is_refused) {
  const auto mesh = mesh::icosphere(0.3, 1);
  const auto model = make_model(scenes::describe(mesh, Compression::none));
  EXPECT_THROW(shares_at(model, -mesh.nodes), membrane::MembraneError);  // turned inside out
}

TEST(AddedBound, governing_element_has_the_largest_bound) {
  const auto mesh = mesh::icosphere(0.3, 1);
  const auto model = make_model(scenes::describe(mesh, Compression::none));
  Eigen::Matrix3Xd x = mesh.nodes;
  x.col(13) *= 1.3;
  const auto state = scenes::evaluated(model, x);
  const int governing = governing_element(model, state);
  EXPECT_NEAR(element_response(model, state, governing).frequency, state.forces.element_frequency,
              16 * scenes::kEps * state.forces.element_frequency);
  EXPECT_TRUE((mesh.elements.col(governing).array() == 13).any());
}
