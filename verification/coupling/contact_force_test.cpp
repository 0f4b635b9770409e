// SPDX-License-Identifier: Apache-2.0
// Contact forces as the gradient of the contact energy, action and reaction, independence of views and
// history.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "claim.hpp"
#include "scenes.hpp"

namespace {

using Eigen::Vector3d;
using scenes::Skin;

using scenes::kRadius;
using scenes::kStiffness;

// Shaken plates with elements from half the sphere to three times it, pressed off centre.
struct Case {
  Skin skin;
  Vector3d centre;
};
std::vector<Case> cases() {
  std::vector<Case> list;
  for (const double size : {0.5, 1.0, 3.0})
    for (unsigned seed = 1; seed <= 4; ++seed) {
      Skin skin = scenes::plate(6, size * kRadius);
      const Skin flat = skin;
      scenes::shake(skin, 0.1 * kRadius, seed);
      skin.masses = flat.masses;
      const double shift = 0.013 * seed;
      list.push_back({skin, {0.3 * shift, shift, kRadius * (0.6 + 0.08 * seed)}});
    }
  return list;
}

TEST(ContactForce, force_eq_minus_energy_gradient) {
  for (const Case& c : cases()) {
    const auto model = scenes::contact(c.skin, kRadius, kStiffness);
    const auto t = scenes::touch(model, c.skin.nodes, c.centre);
    ASSERT_GT(t.result.energy, 0.0);
    const auto energy = [&](const Eigen::Matrix3Xd& x, const Vector3d& centre) {
      return scenes::touch(model, x, centre).result.energy;
    };
    // Rounding eps E/h = 1e-15 and truncation: points that enter within h add kappa A h^2/r each; both are
    // below 1e-6 of the force at h = 1e-9 m.
    const double h = 1e-9, tolerance = 1e-6 * t.result.force.norm();
    for (Eigen::Index a = 0; a < c.skin.nodes.cols(); ++a)
      for (int i = 0; i < 3; ++i) {
        if (t.forces.col(a).isZero()) continue;
        Eigen::Matrix3Xd up = c.skin.nodes, down = c.skin.nodes;
        up(i, a) += h;
        down(i, a) -= h;
        EXPECT_NEAR(t.forces(i, a), -(energy(up, c.centre) - energy(down, c.centre)) / (2.0 * h), tolerance);
      }
    for (int i = 0; i < 3; ++i) {
      const Vector3d d = h * Vector3d::Unit(i);
      EXPECT_NEAR(t.result.force[i],
                  -(energy(c.skin.nodes, c.centre + d) - energy(c.skin.nodes, c.centre - d)) / (2.0 * h),
                  tolerance);
    }
  }
}

TEST(ContactForce, action_eq_reaction_in_force_and_moment) {
  for (const Case& c : cases()) {
    const auto t = scenes::touch(scenes::contact(c.skin, kRadius, kStiffness), c.skin.nodes, c.centre);
    const double scale = t.result.force.norm();
    claim::expect_near({"K.11", "sphere in shaken skins: forces on skin and sphere, their sum [N]",
                        "a few hundred additions of one sign"},
                       (t.forces.rowwise().sum() + t.result.force).norm(), 0.0, 1e-13 * scale);
    Vector3d moment = Vector3d::Zero();
    for (Eigen::Index a = 0; a < t.forces.cols(); ++a)
      moment += Vector3d(c.skin.nodes.col(a)).cross(Vector3d(t.forces.col(a)));
    claim::expect_near({"K.11", "the same: their moments, sum [N m]", "arms below 1 m"},
                       (moment + c.centre.cross(t.result.force)).norm(), 0.0, 1e-13 * scale);
  }
}

TEST(ContactForce, forces_are_added_to_touched_nodes_only) {
  const Case c = cases().front();
  const auto model = scenes::contact(c.skin, kRadius, kStiffness);
  const auto t = scenes::touch(model, c.skin.nodes, c.centre);
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Constant(3, c.skin.nodes.cols(), 7.0);
  auto state = model.make_state();
  model.evaluate(state, c.skin.nodes, {c.centre}, forces);
  int untouched = 0;
  for (Eigen::Index a = 0; a < forces.cols(); ++a) {
    untouched += t.forces.col(a).isZero();
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(forces(i, a), 7.0 + t.forces(i, a), 1e-13 * t.result.force.norm());
  }
  EXPECT_GT(untouched, 0);
}

TEST(ContactForce, padded_views_give_the_same_bits) {
  for (const Case& c : cases()) {
    const auto model = scenes::contact(c.skin, kRadius, kStiffness);
    const auto t = scenes::touch(model, c.skin.nodes, c.centre);
    Eigen::Matrix4Xd nodes = Eigen::Matrix4Xd::Constant(4, c.skin.nodes.cols(), std::nan(""));
    nodes.topRows<3>() = c.skin.nodes;
    Eigen::Matrix4Xd forces = Eigen::Matrix4Xd::Zero(4, c.skin.nodes.cols());
    auto state = model.make_state();
    const auto result = model.evaluate(state, nodes.topRows<3>(), {c.centre}, forces.topRows<3>());
    EXPECT_EQ(result.energy, t.result.energy);
    EXPECT_EQ(Eigen::Matrix3Xd(forces.topRows<3>()), t.forces);
  }
}

// What is known of the gaps is a cache: a long path with it gives the bits of evaluations from scratch.
TEST(ContactForce, carried_state_gives_the_same_bits) {
  const Skin skin = scenes::plate(40, 0.3 * kRadius);
  const auto model = scenes::contact(skin, kRadius, kStiffness);
  auto state = model.make_state();
  Eigen::Matrix3Xd forces(3, skin.nodes.cols());
  int touching = 0, idle_looks = 0;
  for (int n = 0; n < 400; ++n) {
    const double s = 0.02 * n;
    const Vector3d centre(0.2 * std::sin(s), 0.15 * std::sin(1.7 * s),
                          kRadius * (1.5 + 0.9 * std::sin(2.9 * s)));
    forces.setZero();
    const int looks = state.looks;
    const auto result = model.evaluate(state, skin.nodes, {centre}, forces);
    if (n > 0 && result.deepest_element < 0) idle_looks += state.looks - looks;
    const auto t = scenes::touch(model, skin.nodes, centre);
    touching += result.deepest_element >= 0;
    ASSERT_EQ(result.energy, t.result.energy) << n;
    ASSERT_EQ(result.omega_squared(), t.result.omega_squared()) << n;
    ASSERT_EQ(forces, t.forces) << n;
  }
  EXPECT_GT(touching, 50);
  EXPECT_LT(touching, 350);
  // And it is a cache that works: a step may cost 2 % more for it where nothing touches, the work on 2 % of
  // the elements; a look at one costs about as much as that work on three.
  EXPECT_LT(3.0 * idle_looks, 0.02 * model.element_count() * (399 - touching));
}

TEST(ContactForce, result_reports_deepest_point) {
  const Skin skin = scenes::plate(20, 0.1 * kRadius);
  const auto t =
      scenes::touch(scenes::contact(skin, kRadius, kStiffness), skin.nodes, {0.001, 0.002, 0.8 * kRadius});
  // Quadrature points are 0.1 r apart: the nearest misses the foot by at most 0.075 r, 0.003 r in depth.
  EXPECT_NEAR(t.result.penetration, 0.2 * kRadius, 0.004 * kRadius);
  Vector3d centroid = Vector3d::Zero();
  for (const int node : skin.triangles.col(t.result.deepest_element)) centroid += skin.nodes.col(node) / 3.0;
  EXPECT_LT((centroid - Vector3d(0.001, 0.002, 0.0)).norm(), 0.1 * kRadius);
}

}  // namespace
