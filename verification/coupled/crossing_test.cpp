// SPDX-License-Identifier: Apache-2.0
// Volumes that a surface counts twice and inside out, against closed forms.
#include "results/crossing.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "claim.hpp"
#include "crossed_meshes.hpp"
#include "mesh/icosphere.hpp"
#include "results/winding.hpp"

namespace {

using crossed::cube;
using crossed::together;
using driver::Crossing;
using driver::layer_volumes;
using Eigen::Vector3d;
using mesh::Mesh;

constexpr int kLines = 4096;

// Largest distance of a mesh's faces from the round sphere that its nodes are on.
double depth(const Mesh& sphere) {
  double least = 1.0;
  for (const auto& e : sphere.elements.colwise()) {
    const Vector3d a = sphere.nodes.col(e(0)), b = sphere.nodes.col(e(1)), c = sphere.nodes.col(e(2));
    least = std::min(least, std::abs((b - a).cross(c - a).normalized().dot(a)));
  }
  return 1.0 - least;
}

double normal_number(std::mt19937_64& random) {
  return std::normal_distribution<double>{}(random);
}

TEST(crossing, lens_of_two_spheres_is_counted_twice) {
  const Mesh sphere = mesh::icosphere(1.0, 4);
  const auto lens = [](double r, double d) {
    return std::numbers::pi * std::pow(2.0 * r - d, 2) * (d * d + 4.0 * d * r) / (12.0 * d);
  };
  for (const double distance : {0.4, 1.0, 1.6}) {
    const Mesh two = together(sphere, sphere, distance * Vector3d(0.36, 0.48, 0.8));
    const Crossing crossing = driver::find_crossing(two.nodes, two.elements, true);
    EXPECT_GT(crossing.pairs, 0u);
    const auto [volume, error] = crossing.volumes.counted_twice;
    EXPECT_LT(error, 0.01 * volume);
    const double least = lens(1.0 - depth(sphere), distance), most = lens(1.0, distance);
    claim::expect_near({"M.35", "lens of two spheres, counted twice [m3]",
                        "between the spheres in and around the meshes, and five standard errors"},
                       volume, 0.5 * (least + most), 0.5 * (most - least) + 5.0 * error);
    EXPECT_EQ(crossing.volumes.inside_out.value, 0.0);
  }
}

// Between the cubes the length along a line is the same everywhere, so only the rim of the overlap has an
// error.
TEST(crossing, overlap_of_two_cubes_is_counted_twice) {
  for (const Vector3d& move :
       {Vector3d(0.5, 0.25, 0.125), Vector3d(0.5, 0.0, 0.0), Vector3d(0.3, 0.7, 0.0), Vector3d(0, 0, 0)}) {
    const Mesh two = together(cube(), cube(), move);
    const auto [volume, error] = layer_volumes(two.nodes, two.elements, kLines).counted_twice;
    const double exact = (1.0 - move.array()).prod();
    EXPECT_NEAR(volume, exact, 5.0 * error + kLines * 0x1p-53) << move.transpose();
    EXPECT_LT(error, 0.01);
  }
}

TEST(crossing, three_layers_count_twice_too_often) {
  const Mesh two = together(cube(), cube(), {0, 0, 0}), three = together(two, cube(), {0, 0, 0});
  EXPECT_NEAR(layer_volumes(three.nodes, three.elements, kLines).counted_twice.value, 2.0,
              2.0 * kLines * 0x1p-53);  // rounding of the sum
}

TEST(crossing, a_surface_inside_out_has_its_volume_there) {
  Mesh mesh = mesh::icosphere(1.0, 4);
  mesh.elements.row(1).swap(mesh.elements.row(2));
  const auto [twice, inside_out] = layer_volumes(mesh.nodes, mesh.elements, kLines);
  EXPECT_EQ(twice.value, 0.0);
  EXPECT_NEAR(inside_out.value, -mesh::enclosed_volume(mesh.nodes, mesh.elements),
              5.0 * inside_out.standard_error);
}

// y -> x y turns half of the sphere inside out: pi (1 - x^2) |x| across, pi / 4 in each half.
TEST(crossing, half_of_a_figure_of_eight_is_inside_out) {
  const Mesh sphere = mesh::icosphere(1.0, 5);
  Mesh mesh = sphere;
  mesh.nodes.row(1).array() *= mesh.nodes.row(0).array();
  const Crossing crossing = driver::find_crossing(mesh.nodes, mesh.elements, true);
  EXPECT_GT(crossing.pairs, 0u);
  EXPECT_NEAR(mesh::enclosed_volume(mesh.nodes, mesh.elements), 0.0, 1e-14);
  const auto [volume, error] = crossing.volumes.inside_out;
  // The map stretches by less than 2, and changes volumes by less than 1: between the sphere and its mesh are
  // 4 pi depth, half of them on this side. Bending of its edges adds as much.
  claim::expect_near({"M.35", "half of a figure of eight, inside out [m3]",
                      "volume between sphere and mesh, and five standard errors"},
                     volume, 0.25 * std::numbers::pi, 4.0 * std::numbers::pi * depth(sphere) + 5.0 * error);
}

// The signed volume is what is enclosed, plus what is counted twice, less what is inside out: here the union
// of both spheres is known by the same signs.
TEST(crossing, volumes_add_up_to_the_signed_volume) {
  const Mesh sphere = mesh::icosphere(1.0, 3);
  Mesh other = sphere;
  other.elements.row(1).swap(other.elements.row(2));
  const Mesh both = together(sphere, other, {0.9, 0.2, 0.1});
  const auto [twice, inside_out] = layer_volumes(both.nodes, both.elements, kLines);
  const Mesh two = together(sphere, sphere, {0.9, 0.2, 0.1});
  const auto lens = layer_volumes(two.nodes, two.elements, kLines).counted_twice;
  const double volume = mesh::enclosed_volume(sphere.nodes, sphere.elements);
  EXPECT_EQ(twice.value, 0.0) << "w is 1, 0 and -1";
  EXPECT_NEAR(inside_out.value, volume - lens.value, 5.0 * (inside_out.standard_error + lens.standard_error));
}

// Forty turned copies of one figure: their scatter has a relative error of 1/sqrt(80), taken four times.
TEST(crossing, standard_error_is_the_scatter) {
  std::mt19937_64 random(1);
  const Mesh two = together(cube(), cube(), {0.6, 0.4, 0.3});
  constexpr int copies = 40;
  double sum = 0.0, squares = 0.0, variance = 0.0;
  for (int i = 0; i < copies; ++i) {
    Eigen::Quaterniond turn(normal_number(random), normal_number(random), normal_number(random),
                            normal_number(random));
    const Eigen::Matrix3Xd nodes = turn.normalized().toRotationMatrix() * two.nodes;
    const auto [volume, error] = layer_volumes(nodes, two.elements, 1024).counted_twice;
    sum += volume;
    squares += std::pow(volume - 0.4 * 0.6 * 0.7, 2);
    variance += error * error;
  }
  const double ratio = std::sqrt(squares / variance);
  EXPECT_GT(ratio, 1.0 - 4.0 / std::sqrt(80.0));
  EXPECT_LT(ratio, 1.0 + 4.0 / std::sqrt(80.0));
  EXPECT_NEAR(sum / copies, 0.4 * 0.6 * 0.7, 4.0 * std::sqrt(variance) / copies);
}

TEST(crossing, error_falls_as_the_number_of_lines) {
  const Mesh sphere = mesh::icosphere(1.0, 4), two = together(sphere, sphere, {0.7, 0.5, 0.3});
  const double few = layer_volumes(two.nodes, two.elements, 1024).counted_twice.standard_error,
               many = layer_volumes(two.nodes, two.elements, 16384).counted_twice.standard_error;
  EXPECT_GT(few / many, 8.0) << "16 times the lines: 4 for independent lines, 16 for a smooth length";
}

// A fan about the origin covers a square. Lines through its nodes and edges belong to one triangle each.
TEST(crossing, a_point_on_an_edge_belongs_to_one_side) {
  using Point = Eigen::Vector2d;
  const std::vector<Point> rim{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  const auto around = [&](const Point& p) {
    int sum = 0;
    for (std::size_t k = 0; k < rim.size(); ++k)
      sum += driver::winding_about({Point(0, 0), rim[k], rim[(k + 1) % rim.size()]}, p);
    return sum;
  };
  for (int i = -4; i <= 4; ++i)
    for (int j = -4; j <= 4; ++j) {
      const bool inside = i >= -2 && i < 2 && j >= -2 && j < 2;  // a step along x from where it is
      EXPECT_EQ(around({0.5 * i, 0.5 * j}), inside ? 1 : 0) << i << ' ' << j;
    }
}

TEST(crossing, size_and_place_do_not_matter) {
  const Mesh sphere = mesh::icosphere(1.0, 3), two = together(sphere, sphere, {1.0, 0.5, 0.25});
  const auto expected = driver::find_crossing(two.nodes, two.elements, true);
  for (const double scale : {0x1p-100, 0x1p-10, 0x1p100}) {
    const Eigen::Matrix3Xd nodes = scale * two.nodes;
    const auto crossing = driver::find_crossing(nodes, two.elements, true);
    EXPECT_EQ(crossing.pairs, expected.pairs) << scale;
    EXPECT_EQ(crossing.volumes.counted_twice.value,
              std::pow(scale, 3) * expected.volumes.counted_twice.value);
  }
}

TEST(crossing, of_no_triangles_is_none) {
  const auto crossing = driver::find_crossing(Eigen::Matrix3Xd(3, 0), Eigen::Matrix3Xi(3, 0), true);
  EXPECT_EQ(crossing.pairs, 0u);
}

}  // namespace
