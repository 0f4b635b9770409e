// SPDX-License-Identifier: Apache-2.0
// Folded bags of the generators: no two elements meet (CGAL, exact), the attachment stays, and little fabric
// is stretched.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "fold_strain.hpp"
#include "intersections.hpp"
#include "mesh/driver_bag.hpp"
#include "mesh/passenger_bag.hpp"
#include "mesh/refine.hpp"

namespace {

using fold_strain::largest_strain;
using mesh::Folding;
using mesh::FoldOptions;
using mesh::FoldType;
using mesh::Mesh;
using mesh::PackSide;

constexpr double bag_gap = 0.6e-3;

struct Bag {
  Mesh mesh;
  Eigen::Matrix3Xd start;
};

Bag refined(Bag bag, int times, const std::vector<std::string>& vents) {
  for (int i = 0; i < times; ++i) {
    Mesh shape = bag.mesh;
    shape.nodes = bag.start;
    bag.start = mesh::refine(shape, vents).nodes;
    bag.mesh = mesh::refine(bag.mesh, vents);
  }
  return bag;
}

Bag driver_bag(int times) {
  mesh::DriverBag bag = mesh::driver_bag();
  return refined({bag.mesh, bag.opened}, times, std::vector<std::string>{"vent_left", "vent_right"});
}

Bag passenger_bag(int times, double factor) {
  const Mesh mesh = mesh::passenger_bag().mesh;
  return refined({mesh, mesh::flatten(mesh, factor)}, times, {"vent"});
}

struct Packing {
  const char* name;
  int times;
  bool driver;
  std::vector<FoldOptions> folds;
};

std::vector<Packing> packings() {
  const auto fold = [](FoldType type, int axis, std::vector<double> at) {
    return FoldOptions{.type = type, .axis = axis, .at = std::move(at), .gap = bag_gap};
  };
  const FoldOptions wide = fold(FoldType::letter, 2, {-0.148, 0.148});
  return {{"driver letter", 0, true, {fold(FoldType::letter, 2, {-0.2, 0.2})}},
          {"driver letter",
           1,
           true,
           {fold(FoldType::letter, 2, {-0.16, 0.15}), fold(FoldType::letter, 1, {0.16, -0.15})}},
          {"driver accordion", 1, true, {fold(FoldType::accordion, 1, {0.12, 0.24})}},
          {"driver roll", 1, true, {fold(FoldType::roll, 2, {0.12, 0.22})}},
          {"passenger letter", 0, false, {wide}},
          {"passenger letter", 1, false, {wide}},
          {"passenger overlapping letter", 1, false, {fold(FoldType::letter, 2, {-0.12, 0.12})}}};
}

// The map of a layer shortens lengths or keeps them, so that lines of nodes along the fold are not stretched.
// Nodes of other elements get different shares, which shears them: the bound for the driver bag is a third of
// the strain without easing.
TEST(Fold, bags_fold_without_meeting_themselves) {
  for (const Packing& packing : packings()) {
    SCOPED_TRACE(packing.name + (" " + std::to_string(packing.times)));
    const Bag bag = packing.driver ? driver_bag(packing.times) : passenger_bag(packing.times, 0.01);
    const auto fixed = mesh::panel_nodes(bag.mesh, "attachment");
    Folding folding(bag.mesh, bag.start, fixed, mesh::thin_side(bag.start, fixed));
    if (packing.driver) folding.press(bag_gap);
    for (const FoldOptions& how : packing.folds) folding.fold(how);
    EXPECT_EQ(intersections::intersecting_pairs(folding.nodes(), bag.mesh.elements), 0);
    for (const int node : fixed) EXPECT_TRUE(folding.nodes().col(node) == bag.start.col(node));
    EXPECT_LT(largest_strain(bag.mesh, folding, true), packing.driver ? 1e-5 : 1e-9);
    EXPECT_LT(largest_strain(bag.mesh, folding, false), packing.driver ? 0.05 : 1e-3);
    EXPECT_GT(mesh::enclosed_volume(folding.nodes(), bag.mesh.elements), 0.0);
  }
}

TEST(Fold, easing_lowers_the_strain_of_a_mesh_without_lines) {
  const Bag bag = driver_bag(1);
  const auto fixed = mesh::panel_nodes(bag.mesh, "attachment");
  double before = 1.0;
  for (const double easing : {0.0, 1.0, 2.0}) {
    Folding folding(bag.mesh, bag.start, fixed, mesh::thin_side(bag.start, fixed));
    folding.press(bag_gap);
    folding.fold({.axis = 2, .at = {0.2}, .gap = bag_gap, .easing = easing});
    const double strain = largest_strain(bag.mesh, folding, false);
    EXPECT_LT(strain, before);
    before = 0.7 * strain;
  }
}

// Prisms over the elements in the plane of the sheets, one third of the heights of its nodes each.
TEST(Fold, press_lays_two_sheets_at_the_gap) {
  const Bag bag = driver_bag(0);
  for (const Eigen::Matrix3Xd& start : {bag.start, bag.mesh.nodes}) {  // opened, and flat as cut
    const auto fixed = mesh::panel_nodes(bag.mesh, "attachment");
    Folding folding(bag.mesh, start, fixed, PackSide{.axis = 0, .sign = 1.0});
    folding.press(bag_gap);
    int seam = 0;
    for (Eigen::Index i = 0; i < start.cols(); ++i) {
      const double height = folding.nodes()(0, i);
      EXPECT_TRUE(height == 0.0 || height == 0.5 * bag_gap || height == bag_gap) << height;
      seam += height == 0.5 * bag_gap;
      EXPECT_TRUE(folding.nodes().col(i).tail<2>() == start.col(i).tail<2>());
    }
    EXPECT_EQ(seam, 6 * 14);
    EXPECT_EQ(mesh::least_layer_distance(folding.nodes(), bag.mesh.elements, 0,
                                         std::vector<bool>(bag.mesh.panel.size(), false)),
              bag_gap);
    double volume = 0.0;
    Eigen::Matrix3Xd plane = start;
    plane.row(0).setZero();
    const Eigen::VectorXd areas = mesh::element_areas(plane, bag.mesh.elements);
    for (int e = 0; e < bag.mesh.element_count(); ++e) {
      const Eigen::Vector3i corners = bag.mesh.elements.col(e);
      volume += areas[e] * std::abs((folding.nodes()(0, corners).array() - 0.5 * bag_gap).mean());
    }
    EXPECT_NEAR(mesh::enclosed_volume(folding.nodes(), bag.mesh.elements) / volume, 1.0, 1e-12);
  }
}

// Above the flat of the back, and above the side walls, front and back are at least as far apart as the walls
// are deep between the rounded corners; the nodes of walls are nearer to each other.
TEST(Fold, walls_are_no_layers) {
  const Bag bag = passenger_bag(0, 0.01);
  const std::vector<bool> none(bag.mesh.panel.size(), false);
  EXPECT_GE(mesh::least_layer_distance(bag.start, bag.mesh.elements, 0, none), 0.01 * (0.68 - 0.05 - 0.10));
}

TEST(Fold, principal_stretches_of_a_plane_map) {
  const Eigen::Matrix3Xd design{{0.0, 0.3, 0.1}, {0.0, 0.1, 0.4}, {0.0, 0.0, 0.0}};
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()).matrix();
  const Eigen::Matrix3d map = turn * Eigen::Vector3d(1.2, 0.4, 1.0).asDiagonal();
  const auto stretches = mesh::principal_stretches(design, map * design, Eigen::Matrix3Xi{{0}, {1}, {2}});
  EXPECT_NEAR(stretches[0][0], 0.4, 1e-14);
  EXPECT_NEAR(stretches[0][1], 1.2, 1e-14);
}

}  // namespace
