// SPDX-License-Identifier: Apache-2.0
// Levels that need no evaluation: the answer is certain, and the results are those of evaluating every level.
#include <gtest/gtest.h>

#include <random>

#include "coupling/side.hpp"
#include "scenes.hpp"

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

using scenes::kRadius;
using scenes::kStiffness;

struct Counts {
  int touching = 0, skipped = 0, far = 0,
      needless = 0;  // levels; far: gap above r; needless: looked at though far
};

// A sphere wanders over a plate that waves; `share` of the true motion is told.
Counts wander(double size, double share, int seed) {
  const scenes::Skin flat = scenes::plate(static_cast<int>(12.0 / size), size * kRadius);
  const auto model = scenes::contact(flat, kRadius, kStiffness);
  auto state = model.make_state();
  Matrix3Xd last = flat.nodes, forces = Matrix3Xd::Zero(3, last.cols());
  Vector3d last_centre = Vector3d::Zero();
  Counts counts;
  for (int n = 0; n < 1500; ++n) {
    const double s = 0.01 * n + seed;
    Matrix3Xd nodes = flat.nodes;
    for (Eigen::Index a = 0; a < nodes.cols(); ++a)
      nodes(2, a) = 0.2 * kRadius * std::sin(3.0 * s + 20.0 * nodes(0, a));
    const Vector3d centre(0.1 * std::sin(s), 0.1 * std::cos(0.7 * s),
                          kRadius * (3.5 + 2.7 * std::sin(2.1 * s)));
    const double motion =
        std::sqrt((nodes - last).colwise().squaredNorm().maxCoeff()) + (centre - last_centre).norm();
    last = nodes;
    last_centre = centre;
    const bool touches = scenes::touch(model, nodes, centre).result.deepest_element >= 0;
    counts.touching += touches;
    const bool far =
        coupling::smallest_gap(flat.triangles, nodes, coupling::Sphere{kRadius}, {centre}).distance > kRadius;
    counts.far += far;
    if (model.stays_clear(state, share * motion)) {
      ++counts.skipped;
      EXPECT_TRUE(!touches || share < 1.0) << n;
      continue;
    }
    counts.needless += far;
    const auto result = model.evaluate(state, nodes, {centre}, forces.setZero());
    const auto fresh = scenes::touch(model, nodes, centre);
    EXPECT_EQ(result.energy, fresh.result.energy) << n;
    EXPECT_EQ(forces, fresh.forces) << n;
  }
  return counts;
}

TEST(ContactIdle, skipped_levels_touch_nothing_and_the_rest_keep_their_bits) {
  for (const double size : {0.3, 1.0, 3.0})
    for (const int seed : {1, 2, 3}) {
      const Counts c = wander(size, 1.0, seed);
      EXPECT_GT(c.touching, 50) << size;
      EXPECT_GT(c.skipped, 800) << size;
      // Half of a gap above r, which a look makes sure of, outlasts 7 levels: they move 0.07 r at most.
      EXPECT_LE(c.needless, 1 + c.far / 7) << size;
    }
}

// As the driver steps: a sphere falls on a plate that waves and is thrown back, told what its levels and the
// ones ahead move. Bits are those of a fresh state, the answer on what is free that of all elements'
// distances.
TEST(ContactIdle, levels_told_their_motion_keep_their_bits) {
  for (const double size : {0.5, 2.0})
    for (const double friction : {0.0, 0.3}) {
      const scenes::Skin flat = scenes::plate(static_cast<int>(12.0 / size), size * kRadius);
      const auto model = scenes::contact(flat, kRadius, kStiffness, 8.41, friction);
      auto state = model.make_state();
      const auto height = [](double s) { return kRadius * (0.9 + 1.5 * std::abs(std::sin(s))); };
      const double step = 4e-3, speed = 1.8 * kRadius + 0.5;  // [m/s] of what both can do against each other
      Matrix3Xd forces = Matrix3Xd::Zero(3, flat.nodes.cols());
      int touching = 0, kept = 0, free = 0, idle = 0, idle_looks = 0;
      for (int n = 0; n < 1500; ++n) {
        const double s = step * n, ahead = 1.5 * step * speed;
        Matrix3Xd nodes = flat.nodes;
        for (Eigen::Index a = 0; a < nodes.cols(); ++a)
          nodes(2, a) += 0.1 * kRadius * std::sin(3.0 * s + 20.0 * nodes(0, a));
        const Vector3d centre(0.1 * std::sin(s), 0.1 * std::cos(0.7 * s), height(s));
        const auto fresh = scenes::touch(model, nodes, centre);
        touching += fresh.result.deepest_element >= 0;
        const double gap =
            coupling::smallest_gap(flat.triangles, nodes, coupling::Sphere{kRadius}, {centre}).distance;
        idle += n > 0 && gap > ahead;
        if (model.stays_clear(state, step * speed, ahead)) {
          EXPECT_GT(gap, ahead) << n;
          continue;
        }
        const int looks = state.looks;
        const auto result = model.evaluate(state, nodes, {centre}, forces.setZero());
        if (n > 0 && gap > ahead) idle_looks += state.looks - looks;
        kept += state.kept;
        free += coupling::ContactModel::free_gap(state) > ahead;
        EXPECT_EQ(result.area, fresh.result.area) << n;
        EXPECT_EQ(result.penetration, fresh.result.penetration) << n;
        EXPECT_EQ(coupling::ContactModel::free_gap(state) > ahead, gap - 1e-9 * kRadius > ahead) << n;
        // Where the step ahead fits into it, at least half of what is free is known, and never more.
        if (gap - 1e-9 * kRadius > ahead) {
          EXPECT_GE(coupling::ContactModel::free_gap(state), 0.5 * gap - 1e-9 * kRadius) << n;
          EXPECT_LE(coupling::ContactModel::free_gap(state), gap) << n;
        }
        if (friction > 0.0) continue;  // a fresh state knows of no stretch
        EXPECT_EQ(forces, fresh.forces) << n;
      }
      EXPECT_GT(touching, 50) << size;
      EXPECT_GT(free, 30) << size;
      EXPECT_GT(state.skips, 100) << size;
      // Positions are kept at the first level and, with friction, in touch.
      EXPECT_EQ(kept > 10, friction > 0.0) << kept;
      // Where the step ahead touches nothing, looks cost 2 % of a step, each that of three elements, and one
      // a level where that is less than one (72 elements).
      EXPECT_LT(idle_looks, std::max(0.02 / 3.0 * model.element_count(), 1.0) * idle) << size;
    }
}

// A promise that was broken by more than it allows is no motion that could be tested.
TEST(ContactIdle, motion_far_beyond_what_was_told_is_refused) {
  const scenes::Skin skin = scenes::plate(6, kRadius);
  const auto model = scenes::contact(skin, kRadius, kStiffness);
  auto state = model.make_state();
  Matrix3Xd forces = Matrix3Xd::Zero(3, skin.nodes.cols());
  const auto go = [&](double height, double motion, double ahead) {
    if (!model.stays_clear(state, motion, ahead))
      model.evaluate(state, skin.nodes, {{0.001, 0.002, height}}, forces.setZero());
  };
  go(1.2 * kRadius, 0.0, 0.3 * kRadius);
  EXPECT_FALSE(state.kept);
  EXPECT_NO_THROW(go(0.8 * kRadius, 0.4 * kRadius, 0.3 * kRadius));
  EXPECT_FALSE(state.kept);
  try {
    go(-0.8 * kRadius, 1.6 * kRadius, 0.9 * kRadius);
    ADD_FAILURE();
  } catch (const coupling::ContactError& error) {
    EXPECT_NE(std::string(error.what()).find("within one step, but only 0.0123 m were expected"),
              std::string::npos)
        << error.what();
  }
}

// Where no nodes were kept, the motion cannot be measured any more.
TEST(ContactIdle, level_without_a_known_motion_is_refused) {
  const scenes::Skin skin = scenes::plate(6, kRadius);
  const auto model = scenes::contact(skin, kRadius, kStiffness);
  auto state = model.make_state();
  Matrix3Xd forces = Matrix3Xd::Zero(3, skin.nodes.cols());
  const Eigen::Vector3d centre(0.0, 0.0, 1.2 * kRadius);
  EXPECT_FALSE(model.stays_clear(state, 0.0, 0.3 * kRadius));
  model.evaluate(state, skin.nodes, {centre}, forces);
  ASSERT_FALSE(state.kept);
  EXPECT_THROW(model.evaluate(state, skin.nodes, {centre}, forces), std::invalid_argument);
  EXPECT_FALSE(model.stays_clear(state, std::nan(""), 0.3 * kRadius));
  EXPECT_THROW(model.evaluate(state, skin.nodes, {centre}, forces), coupling::ContactError);
}

// A corner that is no number is refused where it is looked at.
TEST(ContactIdle, corner_that_is_no_number_is_refused_where_it_is_looked_at) {
  scenes::Skin skin = scenes::plate(6, kRadius);
  const auto model = scenes::contact(skin, kRadius, kStiffness);
  auto state = model.make_state();
  Matrix3Xd forces = Matrix3Xd::Zero(3, skin.nodes.cols());
  model.evaluate(state, skin.nodes, {{0.0, 0.0, 1.1 * kRadius}}, forces);
  skin.nodes(1, 24) = std::nan("");  // under the sphere
  EXPECT_FALSE(model.stays_clear(state, 0.2 * kRadius, 0.1 * kRadius));
  EXPECT_THROW(model.evaluate(state, skin.nodes, {{0.0, 0.0, 1.1 * kRadius}}, forces),
               coupling::ContactError);
}

TEST(ContactIdle, first_level_and_motion_that_is_no_number_are_never_clear) {
  const scenes::Skin skin = scenes::plate(4, kRadius);
  const auto model = scenes::contact(skin, kRadius, kStiffness);
  auto state = model.make_state();
  EXPECT_FALSE(model.stays_clear(state, 0.0));
  Matrix3Xd forces = Matrix3Xd::Zero(3, skin.nodes.cols());
  model.evaluate(state, skin.nodes, {{0.0, 0.0, 10.0 * kRadius}}, forces);
  EXPECT_TRUE(model.stays_clear(state, 0.0));
  EXPECT_FALSE(model.stays_clear(state, std::nan("")));
  EXPECT_FALSE(model.stays_clear(state, 9.0 * kRadius));  // the gap
  EXPECT_TRUE(model.stays_clear(state, 8.0 * kRadius));   // certain from bounding circles, one element short
  EXPECT_FALSE(model.stays_clear(state, kRadius));        // what is left of it
}

// The path over skipped levels is covered too: a centre that jumps across after them is found.
TEST(ContactIdle, jump_after_skipped_levels_is_found) {
  const scenes::Skin skin = scenes::plate(6, kRadius);
  const auto model = scenes::contact(skin, kRadius, kStiffness);
  auto state = model.make_state();
  Matrix3Xd forces = Matrix3Xd::Zero(3, skin.nodes.cols());
  model.evaluate(state, skin.nodes, {{0.001, 0.002, 5.0 * kRadius}}, forces);
  EXPECT_TRUE(model.stays_clear(state, kRadius));
  EXPECT_FALSE(model.stays_clear(state, 8.0 * kRadius));
  EXPECT_THROW(model.evaluate(state, skin.nodes, {{0.003, 0.001, -4.0 * kRadius}}, forces),
               coupling::ContactError);
}

// Slender and obtuse ones too, whose circle about the centroid is wide.
TEST(ContactIdle, any_element_is_found_that_meets_the_sphere) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto any = [&](double size) {
    return Vector3d(size * Vector3d(uniform(generator), uniform(generator), uniform(generator)));
  };
  int met = 0, clear = 0;
  for (int n = 0; n < 5000; ++n) {
    const double size = kRadius * std::exp(1.5 * uniform(generator));
    scenes::Skin skin{Eigen::Vector3i(0, 1, 2), Matrix3Xd(3, 3), {}};
    const Vector3d a = any(size), b = any(size), along = a + 2.0 * uniform(generator) * (b - a);
    skin.nodes << a, b, along + any(0.2 * size);
    scenes::lump_masses(skin, 0.31);
    const auto model = scenes::contact(skin, kRadius, kStiffness);
    const Vector3d centre =
        skin.nodes.col(n % 3) + (1.0 + 0.5 * uniform(generator)) * kRadius * any(1.0).normalized();
    const double gap =
        coupling::smallest_gap(skin.triangles, skin.nodes, coupling::Sphere{kRadius}, {centre}).distance;
    if (gap < -0.4 * kRadius) continue;  // too deep is refused
    auto state = model.make_state();
    Matrix3Xd forces = Matrix3Xd::Zero(3, 3);
    model.evaluate(state, skin.nodes, {centre}, forces);
    EXPECT_EQ(!state.near.empty(), gap < 1e-9 * kRadius) << n << ": " << gap;
    EXPECT_LE(coupling::ContactModel::free_gap(state), std::max(0.0, gap)) << n;
    (gap < 0.0 ? met : clear) += 1;
  }
  EXPECT_GT(met, 500);
  EXPECT_GT(clear, 500);
}

}  // namespace
