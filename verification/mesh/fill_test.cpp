// SPDX-License-Identifier: Apache-2.0
// Filling of closed lines, against CGAL's filling of holes and closed forms.
#include "mesh/fill.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

namespace fill_lines {
namespace {

using mesh::fill;
using Line = Eigen::Matrix3Xd;
using Triangles = std::vector<std::array<int, 3>>;

Line polygon(const std::vector<double>& xy) {
  Line line(3, static_cast<Eigen::Index>(xy.size() / 2));
  for (Eigen::Index i = 0; i < line.cols(); ++i)
    line.col(i) << xy[static_cast<std::size_t>(2 * i)], xy[static_cast<std::size_t>(2 * i + 1)], 0.0;
  return line;
}

// A star of random radii, any way up.
Line star(int corners, std::mt19937_64& random) {
  std::uniform_real_distribution<double> radius(0.2, 1.0), angle(-1.0, 1.0);
  const Eigen::Matrix3d turn = Eigen::Quaterniond(angle(random), angle(random), angle(random), angle(random))
                                   .normalized()
                                   .toRotationMatrix();
  Line line(3, corners);
  for (int i = 0; i < corners; ++i) {
    const double phi = 2.0 * std::numbers::pi * i / corners, r = radius(random);
    line.col(i) = turn * Eigen::Vector3d(r * std::cos(phi), r * std::sin(phi), 0.0);
  }
  return line;
}

double area(const Line& line, const Triangles& triangles) {
  double sum = 0.0;
  for (const auto& [a, b, c] : triangles)
    sum += 0.5 * (line.col(b) - line.col(a)).cross(line.col(c) - line.col(a)).norm();
  return sum;
}

Triangles by_cgal(const Line& line) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> points;
  for (const auto& x : line.colwise()) points.emplace_back(x.x(), x.y(), x.z());
  std::vector<CGAL::Triple<int, int, int>> found;
  CGAL::Polygon_mesh_processing::triangulate_hole_polyline(
      points, std::back_inserter(found), CGAL::parameters::use_delaunay_triangulation(false));
  Triangles triangles;
  for (const auto& t : found) triangles.push_back({t.first, t.second, t.third});
  return triangles;
}

// Each side of the line once, each other side once each way.
bool is_disc(const Triangles& triangles, int corners) {
  std::set<std::pair<int, int>> sides;
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (!sides.insert({t[i], t[(i + 1) % 3]}).second) return false;
  for (const auto& [a, b] : sides)
    if ((b == (a + 1) % corners) == sides.contains({b, a})) return false;
  return static_cast<int>(triangles.size()) == corners - 2;
}

double worst_angle(const Line& line, const Triangles& triangles) {
  double least = std::numbers::pi;
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3d a = line.col(t[(i + 1) % 3]) - line.col(t[i]),
                            b = line.col(t[(i + 2) % 3]) - line.col(t[i]);
      least = std::min(least, std::atan2(a.cross(b).norm(), a.dot(b)));
    }
  return least;
}

TEST(fill, covers_the_inside_once_as_cgal_does) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 200; ++i) {
    const int corners = 3 + i % 40;
    const Line line = star(corners, random);
    const mesh::Filling filling = fill(line);
    ASSERT_EQ(filling.fault, "") << i;
    EXPECT_TRUE(is_disc(filling.triangles, corners)) << i;
    const double inside = mesh::loop_plane(line).area;  // of a simple line in a plane
    EXPECT_NEAR(area(line, filling.triangles), inside, 1e-14 * corners) << i;
    const Triangles other = by_cgal(line);
    EXPECT_TRUE(is_disc(other, corners)) << i;
    EXPECT_NEAR(area(line, other), inside, 1e-14 * corners) << i;
  }
}

// A rectangular mouth has nodes along its sides: no triangle may lie on a side.
TEST(fill, nodes_along_straight_sides_make_no_slivers) {
  std::vector<double> xy;
  for (int i = 0; i < 6; ++i) xy.insert(xy.end(), {0.1 * i, 0.0});
  for (int i = 0; i < 4; ++i) xy.insert(xy.end(), {0.6, 0.1 * i});
  for (int i = 0; i < 6; ++i) xy.insert(xy.end(), {0.6 - 0.1 * i, 0.4});
  for (int i = 0; i < 4; ++i) xy.insert(xy.end(), {0.0, 0.4 - 0.1 * i});
  const Line line = polygon(xy);
  const mesh::Filling filling = fill(line);
  EXPECT_TRUE(is_disc(filling.triangles, 20));
  EXPECT_NEAR(area(line, filling.triangles), 0.24, 1e-15);
  EXPECT_GT(worst_angle(line, filling.triangles), std::atan(0.1 / 0.6));  // a triangle on one cell, across
}

TEST(fill, sides_that_the_surface_has_are_avoided) {
  const Line line = polygon({0, 0, 1, 0, 1.1, 1, 0, 1});  // the shorter diagonal is 1-3
  const auto has = [&](const mesh::Filling& filling, int a, int b) {
    for (const auto& t : filling.triangles)
      if (std::ranges::count(t, a) + std::ranges::count(t, b) < 2) return false;
    return true;
  };
  EXPECT_TRUE(has(fill(line), 1, 3));
  EXPECT_TRUE(has(fill(line, [](int i, int j) { return i == 1 && j == 3; }), 0, 2));
  EXPECT_EQ(fill(line, [](int, int) { return true; }).fault,
            "cannot be filled without a side that the surface already has");
}

TEST(fill, lines_that_no_cap_fits_are_refused) {
  const auto fault = [](const Line& line) { return fill(line).fault; };
  EXPECT_EQ(fault(polygon({0, 0, 2, 0, 0.5, 1.5, 2, 2})), "crosses itself: side 2 meets side 4");
  EXPECT_EQ(fault(polygon({0, 0, 2, 0, 2, 2, 1, 0, 0, 2})),
            "crosses itself: side 1 meets side 3");  // touches
  EXPECT_EQ(fault(polygon({0, 0, 1, 0, 2, 0, 1, 0})), "encloses no area");
  // Two turns: the area of the five points of a pentagram's inner pentagon counts twice.
  Line turns(3, 5);
  for (int i = 0; i < 5; ++i)
    turns.col(i) << std::cos(0.8 * std::numbers::pi * i), std::sin(0.8 * std::numbers::pi * i), 0.0;
  EXPECT_EQ(fault(turns).substr(0, 14), "crosses itself");
  EXPECT_EQ(fault(Line(3, 2)), "has 2 corners, allowed: 3 or more");
  EXPECT_EQ(fault(Line::Random(3, mesh::kMostCorners + 1)), "has 1001 corners, allowed: at most 1000");
}

// A saddle of half-height h on a circle of radius 1: its corners are h off their plane.
TEST(fill, a_line_may_be_a_tenth_of_its_diameter_off_its_plane) {
  const auto saddle = [](double height) {
    Line line(3, 48);
    for (int i = 0; i < 48; ++i) {
      const double phi = 2.0 * std::numbers::pi * i / 48;
      line.col(i) << std::cos(phi), std::sin(phi), height * std::cos(2.0 * phi);
    }
    return line;
  };
  const mesh::LoopPlane plane = mesh::loop_plane(saddle(0.15));
  EXPECT_NEAR(plane.off_plane, 0.15, 1e-15);
  EXPECT_NEAR(plane.area, 24.0 * std::sin(2.0 * std::numbers::pi / 48), 1e-14);
  EXPECT_TRUE(is_disc(fill(saddle(0.15)).triangles, 48));
  EXPECT_EQ(fill(saddle(0.25)).fault.substr(0, 47), "is not plane: a corner is 0.25 m from its plane");
}

}  // namespace
}  // namespace fill_lines
