// SPDX-License-Identifier: Apache-2.0
// Winding number, distances, the smallest gap, the starting side and the swept test of one triangle.
#include "coupling/side.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <random>
#include <string>

#include "bisection.hpp"
#include "claim.hpp"
#include "closed_skins.hpp"

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::vector<Vector3d> directions() {
  std::mt19937 generator(11);
  std::normal_distribution<double> normal;
  std::vector<Vector3d> list;
  for (int i = 0; i < 50; ++i)
    list.push_back(Vector3d(normal(generator), normal(generator), normal(generator)).normalized());
  return list;
}

TEST(Side, winding_number_is_1_inside_and_0_outside) {
  const auto skin = scenes::octasphere(3);
  for (const Vector3d& d : directions())
    for (const double distance : {0.0, 0.3, 0.95, 1.001, 2.0, 30.0}) {
      // 512 solid angles of a few eps each.
      EXPECT_NEAR(coupling::winding_number(skin.triangles, skin.nodes, distance * d),
                  distance < 1.0 ? 1.0 : 0.0, 1e-12);
    }
}

TEST(Side, winding_number_counts_layers_and_orientation) {
  auto inner = scenes::octasphere(2);
  inner.nodes *= 0.5;
  const auto outer = scenes::octasphere(2);
  const auto both = scenes::joined(outer, inner);
  EXPECT_NEAR(coupling::winding_number(both.triangles, both.nodes, {0.1, 0.0, 0.1}), 2.0, 1e-12);
  inner.triangles.row(0).swap(inner.triangles.row(1));
  const auto shell = scenes::joined(outer, inner);
  EXPECT_NEAR(coupling::winding_number(shell.triangles, shell.nodes, {0.1, 0.0, 0.1}), 0.0, 1e-12);
  EXPECT_NEAR(coupling::winding_number(shell.triangles, shell.nodes, {0.7, 0.0, 0.1}), 1.0, 1e-12);
}

TEST(Side, winding_number_of_one_triangle_eq_its_solid_angle) {
  Eigen::Matrix3Xd nodes(3, 3);
  nodes << 0, 2, 0, 0, 0, 2, 2, 2, 2;
  Eigen::Matrix3Xi triangle(3, 1);
  triangle << 0, 1, 2;
  // van Oosterom-Strackee by hand: 0.33983690945412194 sr.
  claim::expect_near({"K.14", "one triangle: solid angle [sr]", "three eps"},
                     4.0 * std::numbers::pi * coupling::winding_number(triangle, nodes, Vector3d::Zero()),
                     0.33983690945412194, 1e-15);
}

// The nearest point by descent over the triangle's own coordinates, as a second route.
double sampled_distance(const Vector3d& p, const Matrix3d& t) {
  double best = 1e300;
  const int n = 400;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const Vector3d x = t.col(0) + (t.col(1) - t.col(0)) * i / n + (t.col(2) - t.col(0)) * j / n;
      best = std::min(best, (x - p).norm());
    }
  return best;
}

TEST(Side, distance_to_triangle_eq_sampled_minimum) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int k = 0; k < 200; ++k) {
    Matrix3d t;
    for (int i = 0; i < 9; ++i) t(i) = uniform(generator);
    const Vector3d p(2.0 * uniform(generator), 2.0 * uniform(generator), 2.0 * uniform(generator));
    const double distance = coupling::distance_to_triangle(p, t.col(0), t.col(1), t.col(2));
    const double sampled = sampled_distance(p, t);
    EXPECT_LE(distance, sampled * (1.0 + 1e-14));
    // The sample misses the foot by at most one cell, 2.5 / 400, in quadrature with the distance.
    EXPECT_GE(distance, std::sqrt(std::max(0.0, sampled * sampled - 2.0 * 6.3e-3 * 6.3e-3)) -
                            6.3e-3 * (distance < 0.1));
  }
}

TEST(Side, distance_to_triangle_without_area_is_that_of_its_edges) {
  const Vector3d a(0, 0, 0), b(1, 0, 0), c(2, 0, 0);
  EXPECT_DOUBLE_EQ(coupling::distance_to_triangle({1.5, 2.0, 0.0}, a, b, c), 2.0);
  EXPECT_DOUBLE_EQ(coupling::distance_to_triangle({5.0, 4.0, 0.0}, a, b, c), 5.0);
  EXPECT_DOUBLE_EQ(coupling::distance_to_triangle({0.0, 3.0, 0.0}, a, a, a), 3.0);
}

TEST(Side, smallest_gap_of_a_plate_eq_height_less_radius) {
  const auto skin = scenes::plate(4, 0.1);
  for (const double height : {0.03, 0.05, 0.2}) {
    const auto gap =
        coupling::smallest_gap(skin.triangles, skin.nodes, coupling::Sphere{0.041}, {{0.031, 0.012, height}});
    EXPECT_NEAR(gap.distance, height - 0.041, 1e-16);
    EXPECT_GE(gap.element, 0);
  }
}

std::string refusal(const Vector3d& centre, double radius) {
  const auto skin = scenes::octasphere(3);
  try {
    coupling::require_outside(skin.triangles, skin.nodes, coupling::Sphere{radius}, {centre});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Side, start_inside_or_overlapping_is_bad_input) {
  EXPECT_EQ(refusal({1.2, 0.0, 0.0}, 0.2), "");  // in touch with the node at x = 1
  EXPECT_EQ(refusal({3.0, 0.0, 0.0}, 0.2), "");
  EXPECT_NE(refusal({1.19, 0.0, 0.0}, 0.2).find("reaches 0.01 m into the skin at element "),
            std::string::npos);
  EXPECT_NE(refusal({0.1, 0.2, 0.0}, 0.2).find("lies inside the bag: must be outside"), std::string::npos);
  EXPECT_EQ(refusal({0.1, 0.2, 0.0}, 0.2).rfind("impactor", 0), 0u);
}

// From inside outwards along an axis that meets a node: refused up to where the sphere touches it.
TEST(Side, start_is_refused_up_to_touch) {
  const auto starts_outside = [](double centre) { return refusal({centre, 0.0, 0.0}, 0.2).empty(); };
  const double nearest =
      claim::largest_passing(0.01, 3.0, 1e-11, [&](double x) { return !starts_outside(x); });
  claim::expect_threshold({"K.24", "sphere of 0.2 m outside a closed skin of 1 m, from its centre outwards",
                           "overlap of 1e-9 radii is round-off; bisection to 1e-11"},
                          {"sphere that starts inside", "distance of the centre = R + r", 1.2, nearest, "m",
                           "nearer: exit 2, naming the impactor and the element"},
                          1.0 - 2e-10, 1.0 + 1e-10);
}

// Fine sampling in time as a second route: least distance of the origin from the moving triangle.
double least_distance(const Matrix3d& start, const Matrix3d& end) {
  double best = 1e300;
  for (int i = 0; i <= 2000; ++i) {
    const Matrix3d u = start + (end - start) * (i / 2000.0);
    best = std::min(best, coupling::distance_to_triangle(Vector3d::Zero(), u.col(0), u.col(1), u.col(2)));
  }
  return best;
}

TEST(Side, swept_test_eq_sampling_in_time) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  int met = 0, clear = 0;
  for (int k = 0; k < 1000; ++k) {
    Matrix3d start, end;
    for (int i = 0; i < 9; ++i) start(i) = uniform(generator), end(i) = uniform(generator);
    const double least = least_distance(start, end), tolerance = 0.01;
    // Between samples the distance changes by at most half a step's motion, 3.5 / 4000.
    if (least > tolerance + 9e-4) {
      EXPECT_FALSE(coupling::path_meets_triangle(start, end, tolerance)) << k;
      ++clear;
    } else if (least < tolerance) {
      EXPECT_TRUE(coupling::path_meets_triangle(start, end, tolerance)) << k;
      ++met;
    }
  }
  EXPECT_GT(met, 50);
  EXPECT_GT(clear, 500);
}

TEST(Side, swept_test_of_a_triangle_at_rest) {
  Matrix3d u;
  u << 1, 0, 0, 0, 1, 0, 0, 0, 1;
  EXPECT_FALSE(coupling::path_meets_triangle(u, u, 1e-3));
  for (const double far : {1e20, 1e100, 1e300}) {
    const Eigen::Matrix3d away = u.array() + far;
    EXPECT_FALSE(coupling::path_meets_triangle(u, away, 1e-3)) << "it ends, however far";
  }
  EXPECT_TRUE(coupling::path_meets_triangle(u, u, 0.6));  // 1/sqrt(3) away
}

TEST(Side, what_is_no_number_and_no_node_is_refused) {
  const auto good = scenes::octasphere(2);
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  const auto all_refuse = [](const auto& skin, const Vector3d& centre, double radius) {
    EXPECT_THROW(coupling::smallest_gap(skin.triangles, skin.nodes, coupling::Sphere{radius}, {centre}),
                 std::invalid_argument);
    EXPECT_THROW(coupling::require_outside(skin.triangles, skin.nodes, coupling::Sphere{radius}, {centre}),
                 std::invalid_argument);
  };
  const Vector3d outside(3.0, 0.0, 0.0);
  for (const double bad : {nan, infinite}) {
    auto skin = good;
    skin.nodes(1, 5) = bad;
    all_refuse(skin, outside, 0.2);
    EXPECT_THROW(coupling::winding_number(skin.triangles, skin.nodes, outside), std::invalid_argument);
    all_refuse(good, {3.0, bad, 0.0}, 0.2);
    EXPECT_THROW(coupling::winding_number(good.triangles, good.nodes, {3.0, bad, 0.0}),
                 std::invalid_argument);
    all_refuse(good, outside, bad);
    Matrix3d u;
    u << 1, 0, 0, 0, 1, 0, 0, 0, 1;
    Matrix3d spoilt = u;
    spoilt(2, 1) = bad;
    EXPECT_THROW(coupling::path_meets_triangle(u, spoilt, 1e-3), std::invalid_argument);
    EXPECT_THROW(coupling::path_meets_triangle(spoilt, u, 1e-3), std::invalid_argument);
    EXPECT_THROW(coupling::path_meets_triangle(u, u, bad), std::invalid_argument);
  }
  all_refuse(good, outside, -0.2);
  for (const int node : {-1, static_cast<int>(good.nodes.cols())}) {
    auto skin = good;
    skin.triangles(2, 3) = node;
    all_refuse(skin, outside, 0.2);
    EXPECT_THROW(coupling::winding_number(skin.triangles, skin.nodes, outside), std::invalid_argument);
  }
}

}  // namespace
