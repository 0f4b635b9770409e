// SPDX-License-Identifier: Apache-2.0
// Contact of a skin with itself (K.44): energy and forces, pressure of flat layers, momentum, limits (K.45).
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "claim.hpp"
#include "skin_scenes.hpp"

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

using scenes::kSkinStiffness;
using scenes::kThickness;

// Uneven plates that are close, and were far at the level before.
struct Pressed {
  scenes::Skin skin;
  coupling::SkinContactModel model;
  coupling::SkinContactState state;
  Matrix3Xd nodes;
  static constexpr int lower = 49;  // nodes of the lower plate

  explicit Pressed(double gap, double friction = 0.0)
      : skin(scenes::two_plates(6, 5, 0.3, 0.03)),
        model(scenes::skin_contact(skin, kThickness, kSkinStiffness, friction)),
        state(model.make_state()),
        nodes(skin.nodes) {
    scenes::level_of(model, state, nodes);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.1, Vector3d(0.01, 0.02, 1.0).normalized()).matrix();
    for (Eigen::Index a = lower; a < nodes.cols(); ++a)
      nodes.col(a) = turn * (nodes.col(a) - Vector3d(0.0, 0.0, 0.03)) + Vector3d(0.007, 0.011, gap);
    scenes::Skin moved = skin;
    moved.nodes = nodes;
    scenes::shake(moved, 0.1 * gap, 7);
    nodes = moved.nodes;
    moved.nodes.rightCols(36).row(2).array() += 0.5 * kThickness;
    scenes::level_of(model, state, moved.nodes);
  }
};

class SkinContactAtGap : public testing::TestWithParam<double> {};

// At 0.7 h the nodes touch, at 0.35 h the edges too.
TEST_P(SkinContactAtGap, TheForcesAreTheGradientOfTheEnergy) {
  Pressed pressed(GetParam() * kThickness);
  coupling::SkinContactState state = pressed.state;
  const auto at = scenes::level_of(pressed.model, state, pressed.nodes);
  ASSERT_GT(at.result.contacts, 60);
  const double largest = at.forces.cwiseAbs().maxCoeff(), step = 1e-8;
  double worst = 0.0;
  for (Eigen::Index i = 0; i < pressed.nodes.size(); ++i) {
    double energy[2];
    for (const int side : {0, 1}) {
      Matrix3Xd nodes = pressed.nodes;
      nodes(i) += side == 0 ? -step : step;
      coupling::SkinContactState from = pressed.state;
      energy[side] = scenes::level_of(pressed.model, from, nodes).result.energy;
    }
    worst = std::max(worst, std::abs((energy[0] - energy[1]) / (2.0 * step) - at.forces(i)));
  }
  EXPECT_LT(worst, 1e-5 * largest);
}

TEST_P(SkinContactAtGap, MomentumAndItsMomentStay) {
  Pressed pressed(GetParam() * kThickness);
  const auto at = scenes::level_of(pressed.model, pressed.state, pressed.nodes);
  Vector3d moment = Vector3d::Zero();
  double size = 0.0;
  for (Eigen::Index a = 0; a < pressed.nodes.cols(); ++a) {
    moment += pressed.nodes.col(a).cross(at.forces.col(a));
    size += at.forces.col(a).norm();
  }
  EXPECT_LT(at.forces.rowwise().sum().norm(), 1e-14 * size);
  EXPECT_LT(moment.norm(), 1e-14 * size);
}
INSTANTIATE_TEST_SUITE_P(Gaps, SkinContactAtGap, testing::Values(0.7, 0.35));

// Nodes over nodes, over edges and over triangles: each node counts once.
TEST(SkinContactForce, FlatLayersFeelThePressureOfTheirGapWhateverTheirMeshes) {
  for (const int cells : {6, 7, 12}) {
    const scenes::Skin skin = scenes::two_plates(6, cells, 0.3, 0.03);
    const auto model = scenes::skin_contact(skin, kThickness, kSkinStiffness);
    auto state = model.make_state();
    scenes::level_of(model, state, skin.nodes);
    const Eigen::Index upper = skin.nodes.cols() - 49;
    Matrix3Xd nodes = skin.nodes;
    for (const double gap : {0.95, 0.9, 0.81}) {
      nodes.rightCols(upper).row(2).setConstant(gap * kThickness);
      const auto level = scenes::level_of(model, state, nodes);
      const double pressure = kSkinStiffness * (1.0 - gap) * kThickness, area = 0.09;
      EXPECT_NEAR(level.forces.rightCols(upper).row(2).sum(), pressure * area, 1e-12 * pressure * area);
      EXPECT_NEAR(level.result.energy, 0.5 * pressure * pressure / kSkinStiffness * area,
                  1e-11 * pressure * pressure / kSkinStiffness * area);
      EXPECT_NEAR(level.result.closest.gap, gap * kThickness, 1e-15);
    }
  }
}

TEST(SkinContactForce, LayersThatStartCloseStartAtRestAndTheirLimitGrows) {
  const scenes::Skin skin = scenes::two_plates(6, 5, 0.3, 0.6 * kThickness);
  const auto model = scenes::skin_contact(skin, kThickness, kSkinStiffness);
  auto state = model.make_state();
  Matrix3Xd nodes = skin.nodes;
  const auto force_at = [&](double gap) {
    nodes.rightCols(36).row(2).setConstant(gap * kThickness);
    return scenes::level_of(model, state, nodes).forces.rightCols(36).row(2).sum() /
           (kSkinStiffness * kThickness * 0.09);
  };
  EXPECT_EQ(force_at(0.6), 0.0);
  EXPECT_EQ(state.limited_nodes(), 49 + 36);
  EXPECT_NEAR(state.smallest_limit(), 0.6 * kThickness, 1e-15);
  EXPECT_NEAR(force_at(0.5), 0.1, 1e-12);
  EXPECT_EQ(force_at(0.7), 0.0);
  EXPECT_NEAR(force_at(0.6), 0.1, 1e-12);  // the limit is now 0.7 h
  EXPECT_EQ(force_at(1.2), 0.0);
  EXPECT_NEAR(state.smallest_limit(), 1.25 * 0.7 * kThickness, 1e-15);
  EXPECT_EQ(force_at(1.2), 0.0);
  EXPECT_EQ(state.limited_nodes(), 0);
  EXPECT_NEAR(force_at(0.9), 0.1, 1e-12);
}

// A node 3 that is a neighbour of the element at an edge 0-1, where its own edges 3-4 and 3-5 touch that one.
struct Corner {
  scenes::Skin skin;
  coupling::SkinContactModel model;
  coupling::SkinContactState state;

  Corner()
      : skin(flat()),
        model(scenes::skin_contact(skin, kThickness, kSkinStiffness)),
        state(model.make_state()) {
    level(3.0);
  }
  static scenes::Skin flat() {
    scenes::Skin skin;
    skin.nodes.resize(3, 6);
    skin.nodes << 0.0, 0.04, 0.02, 0.06, 0.08, 0.06, 0.0, 0.0, 0.03, 0.06, 0.08, 0.09, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0;
    skin.triangles.resize(3, 3);
    skin.triangles << 0, 2, 3, 1, 3, 4, 2, 5, 5;
    scenes::lump_masses(skin, scenes::kDensity);
    return skin;
  }
  // Node 3 at y [h] in front of the edge, 0.2 h above it.
  Matrix3Xd at(double y) const {
    Matrix3Xd nodes(3, 6);
    nodes << -0.02, 0.02, 0.0, 0.0, -0.005, 0.005, 0.0, 0.0, -0.03, 0.0, 0.03, 0.03, 0.0, 0.0, -0.03, 0.002,
        0.012, 0.022;
    nodes.rightCols(3).row(1).array() += y * kThickness;
    return nodes;
  }
  scenes::SkinLevel level(double y) { return scenes::level_of(model, state, at(y)); }
  double area_of(int element) const {
    const Vector3d a = skin.nodes.col(skin.triangles(0, element)),
                   b = skin.nodes.col(skin.triangles(1, element)),
                   c = skin.nodes.col(skin.triangles(2, element));
    return 0.5 * (b - a).cross(c - a).norm();
  }
};

// The node itself touches nothing there. Else the edges would begin to push where it passes.
TEST(SkinContactForce, EdgesPushFromTheirReachOnWhereTheirEndsAreNeighbours) {
  Corner corner;
  const double areas = 0.5 * (2.0 * corner.area_of(0) + 2.0 * corner.area_of(2) + corner.area_of(1));
  for (const double y : {0.9, 0.6, 0.3, 0.1, 1e-9, -1e-9}) {
    const auto level = corner.level(y);
    const double gap = std::hypot(std::max(y, 0.0), 0.2), first = std::max(0.0, 0.8 - gap),
                 second = std::max(0.0, 0.4 - gap);
    claim::expect_near(
        {"K.44", "edges whose common end comes to an edge of its neighbour: energy of kappa a h2",
         "rounding; 1e-9 h past the end"},
        level.result.energy / (areas * kSkinStiffness * kThickness * kThickness),
        0.5 * (first * first + 20.0 * second * second), 1e-7);
  }
  for (const double y : {0.3, -0.3}) {
    coupling::SkinContactState from = corner.state;
    const double force = scenes::level_of(corner.model, from, corner.at(y)).forces.rightCols(3).row(1).sum();
    double energy[2];
    for (const int side : {0, 1}) {
      from = corner.state;
      energy[side] =
          scenes::level_of(corner.model, from, corner.at(y + (side == 0 ? -1e-6 : 1e-6))).result.energy;
    }
    EXPECT_NEAR((energy[0] - energy[1]) / (2e-6 * kThickness), force, 1e-5 * std::abs(force));
  }
}

}  // namespace
