// SPDX-License-Identifier: Apache-2.0
// Parts of a skin that pass each other in a step are found, whatever its length, and those that miss are not;
// wrong calls are refused.
#include <gtest/gtest.h>

#include <limits>

#include "skin_scenes.hpp"

namespace {

using coupling::GapError;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double kSide = 0.1;  // [m]

// Layers of one triangle each. The last one moves.
struct Triangles {
  scenes::Skin skin;
  coupling::SkinContactModel model;
  coupling::SkinContactState state;

  explicit Triangles(const std::vector<Matrix3Xd>& layers)
      : skin(make(layers)),
        model(scenes::skin_contact(skin, scenes::kThickness, scenes::kSkinStiffness)),
        state(model.make_state()) {
    scenes::level_of(model, state, skin.nodes);
  }
  void move(const Vector3d& by) {
    Matrix3Xd nodes = skin.nodes;
    nodes.rightCols(3).colwise() += by;
    scenes::level_of(model, state, nodes);
  }

 private:
  static scenes::Skin make(const std::vector<Matrix3Xd>& layers) {
    scenes::Skin all;
    for (const Matrix3Xd& nodes : layers) {
      scenes::Skin one;
      one.nodes = nodes;
      one.triangles = Eigen::Vector3i(0, 1, 2);
      all = all.nodes.cols() == 0 ? one : scenes::joined(all, one);
    }
    scenes::lump_masses(all, scenes::kDensity);
    return all;
  }
};

Matrix3Xd triangle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  Matrix3Xd nodes(3, 3);
  nodes << a, b, c;
  return kSide * nodes;
}

Matrix3Xd flat(double height) {
  return triangle({0.0, 0.0, height}, {1.0, 0.0, height}, {0.0, 1.0, height});
}

// Upright, with its tip below.
Matrix3Xd spike() {
  return triangle({0.3, 0.3, 0.5}, {0.1, 0.3, 1.5}, {0.5, 0.3, 1.5});
}

// Upright, with an edge below over a corner of the flat one, its ends beyond.
Matrix3Xd blade() {
  return triangle({-0.2, 0.3, 0.5}, {0.3, -0.2, 0.5}, {0.05, 0.05, 1.5});
}

TEST(SkinContactGuard, node_that_jumps_through_an_element_is_named) {
  for (const double jump : {0.6, 1.0, 5.0, 1000.0}) {
    Triangles scene({flat(0.0), spike()});
    try {
      scene.move({0.0, 0.0, -jump * kSide});
      ADD_FAILURE() << jump << ": passed";
    } catch (const GapError& error) {
      EXPECT_NEAR(error.motion(), jump * kSide, 1e-12 * jump);
      EXPECT_EQ(error.pair().gap, 0.0);
      // Its tip, unless what stands on it has passed too.
      if (jump < 1.0) {
        EXPECT_NE(std::string(error.what()).find("node 3 and the element of nodes 0, 1, 2 met"),
                  std::string::npos)
            << error.what();
      }
    }
  }
}

TEST(SkinContactGuard, edge_that_jumps_through_an_edge_is_named) {
  Triangles scene({flat(0.0), blade()});
  try {
    scene.move({0.0, 0.0, -0.8 * kSide});
    ADD_FAILURE() << "passed";
  } catch (const GapError& error) {
    const auto& [first, second, gap] = error.pair();
    EXPECT_EQ(first[0], 0) << error.what();
    EXPECT_GE(first[1], 1) << error.what();
    EXPECT_EQ(second[0], 3) << error.what();
    EXPECT_EQ(second[1], 4) << error.what();
    EXPECT_EQ(gap, 0.0);
  }
}

TEST(SkinContactGuard, jump_through_both_layers_of_a_fold_is_found) {
  Triangles scene({flat(0.0), flat(0.12), spike()});
  EXPECT_THROW(scene.move({0.0, 0.0, -10.0 * kSide}), GapError);
}

// Each step is of many thicknesses and ends close, but no path meets anything.
TEST(SkinContactGuard, parts_that_fly_past_are_let_go) {
  Triangles over({flat(0.0), flat(0.15)});
  EXPECT_NO_THROW(over.move({100.0 * kSide, 0.0, 0.0}));
  EXPECT_NO_THROW(over.move({-100.0 * kSide, 0.0, 0.0}));
  Triangles beside({flat(0.0), spike()});
  EXPECT_NO_THROW(beside.move({0.0, -5.0 * kSide, 0.0}));
  EXPECT_NO_THROW(beside.move({0.0, -5.0 * kSide, -9.0 * kSide}));
  EXPECT_NO_THROW(beside.move({0.0, 0.0, -9.0 * kSide}));
}

TEST(SkinContactGuard, parts_that_meet_at_the_first_level_are_named) {
  scenes::Skin skin = scenes::two_plates(3, 3, 0.15, 0.0);
  const auto model = scenes::skin_contact(skin, scenes::kThickness, scenes::kSkinStiffness);
  auto state = model.make_state();
  EXPECT_THROW(scenes::level_of(model, state, skin.nodes), GapError);
}

TEST(SkinContactGuard, wrong_calls_are_refused) {
  const scenes::Skin skin = scenes::two_plates(3, 3, 0.15, 0.03);
  const auto model = scenes::skin_contact(skin, scenes::kThickness, scenes::kSkinStiffness);
  const auto other = scenes::skin_contact(skin, scenes::kThickness, scenes::kSkinStiffness);
  auto state = model.make_state(), foreign = other.make_state();
  EXPECT_THROW(scenes::level_of(model, foreign, skin.nodes), std::invalid_argument);
  EXPECT_THROW(scenes::level_of(model, state, skin.nodes.leftCols(5)), std::invalid_argument);
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    auto fresh = model.make_state();
    Matrix3Xd nodes = skin.nodes;
    nodes(1, 20) = bad;
    try {
      scenes::level_of(model, fresh, nodes);
      ADD_FAILURE() << bad << " accepted";
    } catch (const coupling::ContactError& error) {
      EXPECT_NE(std::string(error.what()).find("not finite"), std::string::npos) << error.what();
    }
  }
  auto taken = std::move(state);
  EXPECT_THROW(scenes::level_of(model, state, skin.nodes), std::invalid_argument);
  EXPECT_NO_THROW(scenes::level_of(model, taken, skin.nodes));
}

TEST(SkinContactGuard, copied_and_moved_states_go_on_with_the_same_bits) {
  const scenes::Skin skin = scenes::two_plates(5, 4, 0.3, 0.006);
  const auto model = scenes::skin_contact(skin, scenes::kThickness, scenes::kSkinStiffness, 0.3);
  auto state = model.make_state();
  const auto at = [&](int n) {
    scenes::Skin moved = skin;
    scenes::shake(moved, 0.0005, static_cast<unsigned>(n));
    moved.nodes.rightCols(25).row(2).array() += 0.0015 * std::sin(0.3 * n);
    return moved.nodes;
  };
  for (int n = 0; n < 10; ++n) scenes::level_of(model, state, at(n));
  auto copy = state, source = state;
  auto moved = std::move(source);
  for (int n = 10; n < 30; ++n) {
    const auto one = scenes::level_of(model, state, at(n)), two = scenes::level_of(model, copy, at(n)),
               three = scenes::level_of(model, moved, at(n));
    EXPECT_EQ(one.forces, two.forces);
    EXPECT_EQ(one.forces, three.forces);
    EXPECT_EQ(one.result.friction_loss, two.result.friction_loss);
    EXPECT_GT(one.result.contacts, 0);
  }
}

}  // namespace
