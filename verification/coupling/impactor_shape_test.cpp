// SPDX-License-Identifier: Apache-2.0
// Signed distances of the impactors' shapes, and their gaps to triangles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "claim.hpp"
#include "coupling/side.hpp"
#include "refusal.hpp"
#include "shapes.hpp"

namespace {

using Eigen::Vector3d;

// Closest of many samples: of the core less the radius, or of an ellipsoid's surface. `apart` [m] bounds the
// distance of neighbouring samples.
struct Sampled {
  double distance, apart;
};

Sampled sampled_distance(const coupling::Ellipsoid& shape, const Vector3d& p) {
  constexpr int kRings = 600;
  const double step = std::numbers::pi / kRings;
  double least = 1e300;
  for (int i = 0; i <= kRings; ++i)
    for (int j = 0; j < 2 * kRings; ++j) {
      const double polar = step * i, around = step * j;
      const Vector3d unit(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around),
                          std::cos(polar));
      least = std::min(least, (shape.half_axes.cwiseProduct(unit) - p).norm());
    }
  const bool inside = p.cwiseQuotient(shape.half_axes).norm() < 1.0;
  return {inside ? -least : least, step * shape.half_axes.maxCoeff()};
}

Sampled sampled_distance(const coupling::Cylinder& shape, const Vector3d& p) {
  constexpr int kSteps = 20000;
  double least = 1e300;
  for (int i = 0; i <= kSteps; ++i)
    least = std::min(least, (p - Vector3d(0.0, 0.0, shape.half_length * (2.0 * i / kSteps - 1.0))).norm());
  return {least - shape.radius, 2.0 * shape.half_length / kSteps};
}

Sampled sampled_distance(const coupling::Disc& shape, const Vector3d& p) {
  constexpr int kRings = 400;
  double least = 1e300;
  for (int i = 0; i <= kRings; ++i)
    for (int j = 0; j < 4 * kRings; ++j) {
      const double r = shape.radius * i / kRings, around = 0.5 * std::numbers::pi * j / kRings;
      least = std::min(least, (p - Vector3d(r * std::cos(around), r * std::sin(around), 0.0)).norm());
    }
  return {least - shape.rim_radius, 2.0 * shape.radius / kRings};
}

Sampled sampled_distance(const coupling::Sphere& shape, const Vector3d& p) {
  return {p.norm() - shape.radius, 0.0};
}

// Points from the depth of half the size to a distance of twice it.
std::vector<Vector3d> points_near(const coupling::Impactor& shape, int count, unsigned seed) {
  std::mt19937 generator(seed);
  const double reach = coupling::reach_of(shape), size = coupling::size_of(shape);
  std::uniform_real_distribution<double> uniform(-reach - 2.0 * size, reach + 2.0 * size);
  std::vector<Vector3d> points;
  while (static_cast<int>(points.size()) < count) {
    const Vector3d p(uniform(generator), uniform(generator), uniform(generator));
    const double distance = coupling::signed_distance(shape, {}, p).distance;
    if (distance > -0.5 * size && distance < 2.0 * size) points.push_back(p);
  }
  return points;
}

TEST(ImpactorShape, signed_distance_eq_closest_of_many_samples) {
  for (const auto& [name, shape] : scenes::shapes())
    for (const Vector3d& p : points_near(shape, 20, 3)) {
      const double distance = coupling::signed_distance(shape, {}, p).distance;
      const Sampled s = std::visit([&](const auto& one) { return sampled_distance(one, p); }, shape);
      // The next sample is within `apart`; at a right angle to the way it adds apart^2 over the distance.
      const double far = std::max(std::abs(distance), 0.01 * coupling::size_of(shape));
      const double tolerance = std::min(s.apart, s.apart * s.apart / far) + 1e-12;
      claim::expect_near(
          {"K.49", std::string(name) + ": signed distance by samples of its surface or core [m]",
           "spacing of the samples, squared over the distance"},
          s.distance, distance, tolerance);
    }
}

TEST(ImpactorShape, gradient_has_length_1_and_is_the_normal) {
  for (const auto& [name, shape] : scenes::shapes()) {
    const coupling::Pose pose = scenes::tilted({0.3, -0.2, 0.1}, 0.7);
    double length = 0.0, error = 0.0;
    for (const Vector3d& own : points_near(shape, 1000, 5)) {
      const Vector3d p = pose.centre + pose.axes * own;
      const Vector3d normal = coupling::signed_distance(shape, pose, p).normal;
      length = std::max(length, std::abs(normal.norm() - 1.0));
      const double h = 1e-6 * coupling::size_of(shape);
      for (int i = 0; i < 3; ++i) {
        const Vector3d d = h * Vector3d::Unit(i);
        const double slope = (coupling::signed_distance(shape, pose, p + d).distance -
                              coupling::signed_distance(shape, pose, p - d).distance) /
                             (2.0 * h);
        error = std::max(error, std::abs(slope - normal[i]));
      }
    }
    claim::expect_near(
        {"K.49", std::string(name) + ": length of the normal at 1000 points, largest error [-]", "rounding"},
        length, 0.0, 1e-13);
    // Rounding 1e-15/h; a point within h of where the curvature jumps is off by h over half the size.
    claim::expect_near({"K.49", std::string(name) + ": its gradient by differences there, largest error [-]",
                        "steps of 1e-6 of the size"},
                       error, 0.0, 3e-6);
  }
}

// In the middle planes, where terms of (K.50) vanish, and at the centre.
TEST(ImpactorShape, ellipsoid_has_closed_forms_on_its_axes) {
  const coupling::Ellipsoid shape{{0.3, 0.2, 0.1}};
  const auto distance = [&](double x, double y, double z) {
    return coupling::signed_distance(shape, {}, {x, y, z}).distance;
  };
  EXPECT_NEAR(distance(0.5, 0.0, 0.0), 0.2, 1e-15);
  EXPECT_NEAR(distance(0.0, 0.0, -0.7), 0.6, 1e-15);
  EXPECT_NEAR(distance(0.29, 0.0, 0.0), -0.01, 1e-15);
  EXPECT_NEAR(distance(0.0, 0.19, 0.0), -0.01, 1e-15);
  EXPECT_NEAR(distance(0.0, 0.0, 0.0), -0.1, 1e-15);
  // Deeper on the long axis than its radius of curvature: x = x0 a^2/(a^2 - c^2), z = c sqrt(1 - x^2/a^2).
  const double x = 0.2 * 0.09 / 0.08, z = 0.1 * std::sqrt(1.0 - x * x / 0.09);
  EXPECT_NEAR(distance(0.2, 0.0, 0.0), -std::hypot(x - 0.2, z), 1e-15);
  EXPECT_NEAR(distance(0.2, 0.0, 1e-12), -std::hypot(x - 0.2, z), 2e-12);
}

// The least of many points of the triangle is at most their spacing above the gap.
TEST(ImpactorShape, gap_eq_least_signed_distance_of_a_triangle) {
  std::mt19937 generator(11);
  for (const auto& [name, shape] : scenes::shapes()) {
    const double size = coupling::size_of(shape), reach = coupling::reach_of(shape);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    int overlaps = 0;
    for (int k = 0; k < 300; ++k) {
      const coupling::Pose pose = scenes::tilted({uniform(generator), 0.2, 0.1}, 3.0 * uniform(generator));
      Eigen::Matrix3Xd nodes(3, 3);
      const double spread = (k % 3 == 0 ? 0.2 : 2.0) * reach;
      const Vector3d middle =
          pose.centre + 1.2 * reach * Vector3d(uniform(generator), uniform(generator), uniform(generator));
      for (int i = 0; i < 3; ++i)
        nodes.col(i) = middle + spread * Vector3d(uniform(generator), uniform(generator), uniform(generator));
      if (k % 7 == 0) {  // along the body's own axes: parallel to faces and sides
        for (int i = 0; i < 3; ++i) nodes.col(i) = pose.centre + pose.axes * (nodes.col(i) - pose.centre);
        const Vector3d flat = k % 2 == 0 ? pose.axes.col(2) : pose.axes.col(0);
        for (int i = 0; i < 3; ++i) nodes.col(i) -= flat.dot(nodes.col(i) - middle) * flat;
      }
      const Eigen::Matrix3Xi triangles{{0}, {1}, {2}};
      const double gap = coupling::smallest_gap(triangles, nodes, shape, pose).distance;
      constexpr int kSteps = 60;
      double least = 1e300;
      for (int i = 0; i <= kSteps; ++i)
        for (int j = 0; i + j <= kSteps; ++j) {
          const Vector3d p = (nodes.col(0) * i + nodes.col(1) * j + nodes.col(2) * (kSteps - i - j)) / kSteps;
          least = std::min(least, coupling::signed_distance(shape, pose, p).distance);
        }
      const double longest = (nodes.col(1) - nodes.col(0)).norm() + (nodes.col(2) - nodes.col(0)).norm();
      EXPECT_LE(gap, least + 1e-9 * size) << name << ' ' << k;
      if (least > -0.9 * size) {
        EXPECT_GE(gap, least - longest / kSteps) << name << ' ' << k;
      }
      overlaps += gap < 0.0;
    }
    EXPECT_GT(overlaps, 30) << name;
    EXPECT_LT(overlaps, 270) << name;
  }
}

TEST(ImpactorShape, gap_to_a_plate_eq_height_less_half_the_thickness) {
  const auto skin = scenes::plate(40, 0.1);
  for (const double height : {0.17, 0.21, 0.5}) {
    const auto gap = [&](const coupling::Impactor& shape, const Eigen::Matrix3d& axes) {
      return coupling::smallest_gap(skin.triangles, skin.nodes, shape, {{0.031, 0.012, height}, axes})
          .distance;
    };
    const Eigen::Matrix3d up = Eigen::Matrix3d::Identity();
    Eigen::Matrix3d side;
    side << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    EXPECT_NEAR(gap(coupling::Ellipsoid{{0.3, 0.2, 0.1}}, up), height - 0.1, 1e-12);
    EXPECT_NEAR(gap(coupling::Cylinder{0.1, 0.05}, up), height - 0.15, 1e-12);
    EXPECT_NEAR(gap(coupling::Cylinder{0.1, 0.05}, side), height - 0.1, 1e-12);
    EXPECT_NEAR(gap(coupling::Disc{0.1, 0.02}, up), height - 0.02, 1e-12);
    EXPECT_NEAR(gap(coupling::Disc{0.1, 0.02}, side), height - 0.12, 1e-12);
  }
}

TEST(ImpactorShape, measures_follow_from_the_dimensions) {
  const double pi = std::numbers::pi;
  const coupling::Impactor ellipsoid = coupling::Ellipsoid{{0.3, 0.1, 0.2}},
                           cylinder = coupling::Cylinder{0.1, 0.3}, disc = coupling::Disc{0.2, 0.05},
                           sphere = coupling::Sphere{0.1};
  EXPECT_NEAR(coupling::size_of(ellipsoid), 0.01 / 0.3, 1e-15);
  EXPECT_NEAR(coupling::reach_of(ellipsoid), 0.3, 1e-15);
  EXPECT_NEAR(coupling::section_of(ellipsoid), pi * 0.06, 1e-15);
  EXPECT_NEAR(coupling::size_of(cylinder), 0.1, 1e-15);
  EXPECT_NEAR(coupling::reach_of(cylinder), 0.4, 1e-15);
  EXPECT_NEAR(coupling::section_of(cylinder), 0.12 + pi * 0.01, 1e-15);
  EXPECT_NEAR(coupling::size_of(disc), 0.05, 1e-15);
  EXPECT_NEAR(coupling::reach_of(disc), 0.25, 1e-15);
  EXPECT_NEAR(coupling::section_of(disc), pi * 0.0625, 1e-15);
  EXPECT_NEAR(coupling::size_of(sphere), 0.1, 1e-15);
  EXPECT_NEAR(coupling::reach_of(sphere), 0.1, 1e-15);
  EXPECT_NEAR(coupling::section_of(sphere), pi * 0.01, 1e-15);
}

TEST(ImpactorShape, dimensions_and_axes_out_of_range_are_refused) {
  const double nan = std::nan("");
  const std::pair<const char*, coupling::Impactor> faults[] = {
      {"impactor.radius", coupling::Sphere{0.0}},
      {"impactor.half_axes", coupling::Ellipsoid{{0.1, nan, 0.1}}},
      {"impactor.half_axes", coupling::Ellipsoid{{0.1, 0.1, 0.0}}},
      {"impactor.radius", coupling::Cylinder{-0.1, 0.1}},
      {"impactor.half_length", coupling::Cylinder{0.1, -0.1}},
      {"impactor.radius", coupling::Disc{-0.1, 0.1}},
      {"impactor.rim_radius", coupling::Disc{0.1, 0.0}}};
  for (const auto& [field, shape] : faults) {
    const std::string message = refusal([&shape = shape] { coupling::require_valid(shape); });
    EXPECT_EQ(message.rfind(std::string(field) + " = ", 0), 0u) << message;
  }
  const coupling::Impactor disc = coupling::Disc{0.1, 0.02};
  Eigen::Matrix3d mirrored = Eigen::Matrix3d::Identity(), skewed = mirrored, spoilt = mirrored;
  mirrored(0, 0) = -1.0;
  skewed(0, 1) = 1e-6;
  spoilt(2, 2) = nan;
  for (const Eigen::Matrix3d& axes : {mirrored, skewed, spoilt})
    EXPECT_EQ(refusal([&] {
                coupling::signed_distance(disc, {Vector3d::Zero(), axes}, {0.1, 0.2, 0.3});
              }).rfind("pose.axes = ", 0),
              0u);
}

}  // namespace
