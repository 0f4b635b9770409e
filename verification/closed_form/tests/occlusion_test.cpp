// SPDX-License-Identifier: Apache-2.0
// Reference numbers: 40-digit arithmetic (mpmath), rounded to 17 digits: van Oosterom and Strackee, and the
// spherical cap.
#include "closed_form/occlusion.hpp"

#include <numbers>

#include "check.hpp"

namespace {

using namespace closed_form;
using std::numbers::pi;
using test::expect_refused;
using test::expect_relative;
using test::kAlgebra;

constexpr Triangle2 kTarget{{{0, 0}, {2, 0}, {0, 2}}};

TEST(ClosedFormOcclusion, hidden_triangle_eq_rational_cases) {
  expect_relative(hidden_triangle_fraction({{{0, 0}, {0.5, 0}, {0, 0.5}}}, 1.0, kTarget, 2.0), 0.25,
                  kAlgebra);
  expect_relative(hidden_triangle_fraction({{{0.25, 0.25}, {1, 0.25}, {0.25, 1}}}, 1.0, kTarget, 2.0), 0.25,
                  kAlgebra);
  // Either orientation, and the general law (z2/z1)^2 (s1/s2)^2.
  expect_relative(hidden_triangle_fraction({{{0, 0}, {0, 0.3}, {0.3, 0}}}, 1.5, kTarget, 3.0), 0.09,
                  kAlgebra);
  EXPECT_EQ(hidden_triangle_fraction({{{-2, -2}, {-1, -2}, {-2, -1}}}, 1.0, kTarget, 2.0), 0.0);
  expect_relative(hidden_triangle_fraction({{{-5, -5}, {50, -5}, {-5, 50}}}, 1.0, kTarget, 2.0), 1.0,
                  kAlgebra);
}

TEST(ClosedFormOcclusion, hexagram_hides_two_thirds) {
  const double h = std::sqrt(0.75);
  const Triangle2 up{{{1, 0}, {-0.5, h}, {-0.5, -h}}};
  const Triangle2 down{{{-0.5, 0}, {0.25, -0.5 * h}, {0.25, 0.5 * h}}};
  expect_relative(hidden_triangle_fraction(down, 1.0, up, 2.0), 2.0 / 3.0, kAlgebra);
}

TEST(ClosedFormOcclusion, discs_eq_closed_form_and_limits) {
  expect_relative(hidden_coaxial_disc_fraction(0.3, 1.0, 1.0, 2.0), 0.36, kAlgebra);
  EXPECT_EQ(hidden_coaxial_disc_fraction(0.8, 1.0, 1.0, 2.0), 1.0);
  expect_relative(hidden_disc_fraction(0.3, 1.0, 1.0, 2.0, 0.0), 0.36, kAlgebra);
  expect_relative(hidden_disc_fraction(0.3, 1.0, 1.0, 2.0, 0.19), 0.36, kAlgebra);  // shadow still inside
  EXPECT_EQ(hidden_disc_fraction(0.3, 1.0, 1.0, 2.0, 0.81), 0.0);
  expect_relative(circle_overlap_area(1.0, 1.0, 1.0), 2 * pi / 3 - std::sqrt(3.0) / 2, kAlgebra);
}

TEST(ClosedFormOcclusion, lens_area_eq_quadrature) {
  for (const double r2 : {0.4, 1.0, 1.7})
    for (const double d : {0.9, 1.2}) {
      // Width of the lens at height y, substituted y = y_max sin(t) for smooth ends.
      const double x = (d * d + 1.0 - r2 * r2) / (2 * d);
      if (std::abs(x) >= 1.0 || x > d) continue;  // lens of less than half a circle each side
      const double top = std::sqrt(1.0 - x * x);
      const auto width = [&](double t) {
        const double y = top * std::sin(t);
        return (std::sqrt(1 - y * y) + std::sqrt(r2 * r2 - y * y) - d) * top * std::cos(t);
      };
      if (x >= 0.0)
        expect_relative(circle_overlap_area(1.0, r2, d), test::integrate(width, -pi / 2, pi / 2), 1e-10);
    }
}

TEST(ClosedFormOcclusion, sphere_shadow_eq_ray_geometry) {
  for (const double D : {0.6, 0.9, 1.7}) {
    const double r = 0.5;
    const double R = 2.0;
    // The tangent ray from (-D, 0) meets the shell where its angle from the axis is the half angle.
    const double slope = std::asin(r / D);
    const double along = D * std::cos(slope) + std::sqrt(R * R - r * r);
    const double angle = std::atan2(along * std::sin(slope), along * std::cos(slope) - D);
    expect_relative(sphere_shadow_half_angle(r, D, R), angle, kAlgebra);
    // Surface the source sees: cap of half angle acos(r/D).
    expect_relative(visible_sphere_fraction(r, D), 0.5 * (1 - std::cos(std::acos(r / D))), kAlgebra);
    expect_relative(sphere_solid_angle(r, D), 2 * pi * (1 - std::sqrt(1 - r * r / (D * D))), 1e-13);
  }
  expect_relative(sphere_solid_angle(1e-6, 1.0), pi * 1e-12, 1e-11);  // flat disc, no cancellation
  expect_relative(sphere_solid_angle(0.5, 1.0), 0.84178721447693293, kAlgebra);
}

TEST(ClosedFormOcclusion, triangle_solid_angle_eq_reference_and_octant) {
  expect_relative(triangle_solid_angle({0, 0, 2}, {2, 0, 2}, {0, 2, 2}), 0.33983690945412194, kAlgebra);
  expect_relative(triangle_solid_angle({3, 0, 0}, {0, 1, 0}, {0, 0, 7}), pi / 2, kAlgebra);
  expect_relative(triangle_solid_angle({0, 1, 0}, {3, 0, 0}, {0, 0, 7}), pi / 2, kAlgebra);
}

// Counts faces of an explicit icosahedron whose plane has the point outside.
TEST(ClosedFormOcclusion, icosahedron_faces_eq_count) {
  const double inradius = std::sqrt((5 + 2 * std::sqrt(5.0)) / 15);  // over the circumradius
  // Cosine between the axis and the four rings of five face normals.
  const double first = inradius;
  const double second = std::sqrt((5 - 2 * std::sqrt(5.0)) / 15);
  for (const double D : {1.01, 2.0, 4.2, 4.3, 100.0}) {
    const int faces = 5 * (first * D > inradius) + 5 * (second * D > inradius);
    EXPECT_EQ(icosahedron_visible_faces(D), faces);
  }
  EXPECT_EQ(icosahedron_visible_faces(0.5), 20);
}

TEST(ClosedFormOcclusion, bad_parameters_are_refused_by_name) {
  expect_refused([] { hidden_coaxial_disc_fraction(0.3, 2.0, 1.0, 1.0); }, "target_distance");
  expect_refused([] { hidden_triangle_fraction({{{0, 0}, {1, 1}, {2, 2}}}, 1.0, kTarget, 2.0); }, "occluder");
  expect_refused([] { sphere_shadow_half_angle(1.0, 0.5, 2.0); }, "source_distance");
  expect_refused([] { icosahedron_visible_faces(1.0); }, "distance_ratio");
}

}  // namespace
