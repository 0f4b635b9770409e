// SPDX-License-Identifier: Apache-2.0
// The bound of the self-contact's omega^2 against the Hessian of its energy (K.46).
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "claim.hpp"
#include "eigenvalues.hpp"
#include "skin_scenes.hpp"

namespace {

using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;

using scenes::kDensity;
using scenes::kSkinStiffness;
using scenes::kThickness;

// Two plates, the upper one with a finer mesh, turned and shaken, at `gap` [h] of their middle planes.
struct Shaken {
  scenes::Skin skin = scenes::two_plates(3, 4, 0.08, 3.0 * kThickness);
  coupling::SkinContactModel model;
  coupling::SkinContactState state;
  Matrix3Xd nodes;
  static constexpr Eigen::Index upper = 25;

  Shaken(double gap, double shake, unsigned seed, double friction = 0.0)
      : model(scenes::skin_contact(skin, kThickness, kSkinStiffness, friction)), state(model.make_state()) {
    scenes::level_of(model, state, skin.nodes);
    scenes::Skin moved = skin;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.3 * seed, Vector3d::UnitZ()).toRotationMatrix();
    auto top = moved.nodes.rightCols(upper);
    top.row(2).setConstant(gap * kThickness);
    top = turn * top;
    scenes::shake(moved, shake * gap * kThickness, seed);
    nodes = moved.nodes;
    // Down in one step, without passing.
    moved.nodes.rightCols(upper).row(2).array() += 0.5 * kThickness;
    scenes::level_of(model, state, moved.nodes);
    scenes::level_of(model, state, nodes);  // what comes fast counts as stiffer
  }
  scenes::SkinLevel level(const Matrix3Xd& at) const {
    coupling::SkinContactState from = state;
    return scenes::level_of(model, from, at);
  }
  // Largest eigenvalue of the mass-scaled Hessian, by central differences of the forces [1/s2].
  double largest_omega_squared() const {
    const Eigen::Index size = nodes.size();
    MatrixXd hessian(size, size);
    const double step = 1e-9;
    for (Eigen::Index k = 0; k < size; ++k) {
      Matrix3Xd x = nodes, y = nodes;
      x(k) += step;
      y(k) -= step;
      const Matrix3Xd change = (level(y).forces - level(x).forces) / (2.0 * step);
      hessian.col(k) = Eigen::Map<const Eigen::VectorXd>(change.data(), size);
    }
    for (Eigen::Index i = 0; i < size; ++i)
      for (Eigen::Index k = 0; k < size; ++k)
        hessian(i, k) /= std::sqrt(skin.masses[static_cast<std::size_t>(i / 3)] *
                                   skin.masses[static_cast<std::size_t>(k / 3)]);
    return dense::largest_eigenvalue(0.5 * (hessian + hessian.transpose()));
  }
};

// Below h/2 the ends of edges, whose terms are negative, are left out of the bound.
TEST(SkinContactBound, bound_covers_the_hessian_of_shaken_layers) {
  for (const double gap : {0.9, 0.83, 0.75, 0.55, 0.35})
    for (const double shake : {0.0, 0.05, 0.1})
      for (unsigned seed = 1; seed <= 3; ++seed) {
        const Shaken scene(gap, shake, seed);
        const double bound = scene.level(scene.nodes).result.omega_squared;
        const double exact = scene.largest_omega_squared();
        ASSERT_GT(exact, 0.0);
        EXPECT_LE(exact, bound * 1.01) << gap << ' ' << shake << ' ' << seed;
        EXPECT_GT(exact, bound / (gap > 0.7 ? 4.0 : 30.0))
            << gap << ' ' << shake << ' ' << seed;  // of use; elements that tilt add 1 % at most
      }
}

// The layer in the middle of three of one mesh.
TEST(SkinContactBound, layer_that_touches_on_both_sides_takes_the_full_bound) {
  for (const double friction : {0.0, 0.3}) {
    scenes::Skin skin = scenes::two_plates(3, 3, 0.15, kThickness), third = scenes::plate(3, 0.05);
    third.nodes.row(2).setConstant(2.0 * kThickness);
    skin = scenes::joined(skin, third);
    const auto model = scenes::skin_contact(skin, kThickness, kSkinStiffness, friction);
    auto state = model.make_state();
    skin.nodes.row(2) *= 1.1;
    scenes::level_of(model, state, skin.nodes);
    skin.nodes.row(2) *= 0.9;
    for (int level = 0; level < 2; ++level) scenes::level_of(model, state, skin.nodes);
    claim::expect_relative({"K.46", "layer between two: omega^2 by 4 kappa sqrt(1 + mu^2) / surface density",
                            "some ten additions a node"},
                           scenes::level_of(model, state, skin.nodes).result.omega_squared /
                               (4.0 * kSkinStiffness / kDensity * std::hypot(1.0, friction)),
                           1.0, 1e-12);
    EXPECT_NEAR(model.full_omega_squared() / (4.0 * kSkinStiffness / kDensity * std::hypot(1.0, friction)),
                1.0, 1e-12);
  }
  EXPECT_DOUBLE_EQ(coupling::default_skin_stiffness(20.0, 3e9, kDensity), 20.0 * 3e9 * kDensity / 4.0);
}

// A small plate over the inside of an element, so that each of its nodes touches that one alone.
TEST(SkinContactBound, KinksAreNodesThatBeginOrCeaseToTouchAndTheirSecondHalf) {
  constexpr double side = 0.03;
  scenes::Skin small = scenes::plate(1, side);
  small.nodes.colwise() += Vector3d(0.08, -0.05, 0.0);
  const scenes::Skin skin = scenes::joined(scenes::plate(1, 0.4), small);
  const auto model = scenes::skin_contact(skin, kThickness, kSkinStiffness);
  auto state = model.make_state();
  Matrix3Xd nodes = skin.nodes;
  double before = 1.5;  // [h]
  const double gaps[] = {1.5, 1.2, 1.19, 0.9, 0.89, 0.98, 1.01}, jumps[] = {0, 1, 0, 20, 0, 1, 0};
  for (std::size_t k = 0; k < std::size(gaps); ++k) {
    const double gap = gaps[k];  // [h]
    nodes.rightCols(4).row(2).setConstant(gap * kThickness);
    const double closing = (gap - before) * kThickness;
    const auto result = scenes::level_of(model, state, nodes).result;
    claim::expect_near({"K.48", "small plate over an element: kink energy, of kappa A_n/2 per node and h2",
                        "rounding of some ten additions"},
                       result.kink_energy / (kSkinStiffness * 0.5 * side * side * kThickness * kThickness),
                       jumps[k] * closing * closing / (kThickness * kThickness), 1e-12);
    before = gap;
  }
}

TEST(SkinContactBound, NodesThatStartAtTheirLimitCountInTheFirstStep) {
  for (const double gap : {0.7, 1.0, 1.1}) {
    const scenes::Skin skin = scenes::two_plates(3, 4, 0.15, gap * kThickness);
    const auto model = scenes::skin_contact(skin, kThickness, kSkinStiffness);
    auto state = model.make_state();
    const double start = scenes::level_of(model, state, skin.nodes).result.omega_squared;
    if (gap > 1.0) {
      EXPECT_EQ(start, 0.0);
      continue;
    }
    Matrix3Xd nodes = skin.nodes;
    nodes.rightCols(25).row(2).array() -= 1e-6 * kThickness;
    const double touching = scenes::level_of(model, state, nodes).result.omega_squared;
    EXPECT_GE(start, (1.0 - 1e-12) * touching) << gap;
    EXPECT_LE(start, 8.0 * touching) << gap << ": up to eight elements have a corner in common";
  }
}

}  // namespace
