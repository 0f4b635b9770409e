// SPDX-License-Identifier: Apache-2.0
// The search of a skin's contact with itself finds what a look at every pair finds, to the bit; nothing
// passes.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "skin_scenes.hpp"

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// A sphere that crumples under an outer pressure, with contact alone against it.
struct Crumple {
  scenes::Skin skin = scenes::octasphere(3);
  Matrix3Xd nodes, velocity;

  explicit Crumple(double radius) {
    skin.nodes *= radius;
    scenes::lump_masses(skin, 0.31);
    nodes = skin.nodes;
    velocity.setZero(3, nodes.cols());
    std::mt19937_64 random(3);
    for (Eigen::Index i = 0; i < velocity.size(); ++i)
      velocity(i) = 4.0 * (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5);
    velocity -= 20.0 * (nodes / radius);
    velocity.row(2) *= 2.0;
  }
  void advance(const Matrix3Xd& forces, double dt) {
    for (Eigen::Index a = 0; a < nodes.cols(); ++a)
      velocity.col(a) += dt / skin.masses[static_cast<std::size_t>(a)] * forces.col(a);
    nodes += dt * velocity;
  }
};

TEST(SkinContactSearch, EveryPairGivesTheSameBits) {
  Crumple crumple(0.15);
  const auto model = scenes::skin_contact(crumple.skin, 6e-3, 1e8);
  auto searched = model.make_state(), all = model.make_state(true);
  int most = 0;
  bool edges = false;
  for (int n = 0; n < 150; ++n) {
    const auto found = scenes::level_of(model, searched, crumple.nodes);
    const auto each = scenes::level_of(model, all, crumple.nodes);
    ASSERT_EQ(found.forces, each.forces) << n;
    ASSERT_EQ(found.result.energy, each.result.energy) << n;
    ASSERT_EQ(found.result.omega_squared, each.result.omega_squared) << n;
    ASSERT_EQ(found.result.contacts, each.result.contacts) << n;
    ASSERT_EQ(searched.limited_nodes(), all.limited_nodes()) << n;
    most = std::max(most, found.result.contacts);
    edges = edges || found.result.closest.first[1] >= 0;
    crumple.advance(found.forces, 2e-5);
  }
  EXPECT_GT(most, 20);
  EXPECT_TRUE(edges);
  EXPECT_LT(searched.looks(), all.looks() / 20);
}

}  // namespace
