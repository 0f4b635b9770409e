// SPDX-License-Identifier: Apache-2.0
// The flattened initial shape: attachment kept, no element inverted, no two elements intersecting (CGAL,
// exact).
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>
#include <stdexcept>

#include "intersections.hpp"
#include "mesh/icosphere.hpp"
#include "mesh/passenger_bag.hpp"
#include "mesh/surface_check.hpp"

namespace {

using intersections::intersecting_pairs;
using mesh::Mesh;

TEST(Flattening, attachment_stays_and_depth_shrinks) {
  const Mesh mesh = mesh::passenger_bag().mesh;
  const Eigen::Matrix3Xd nodes = mesh::flatten(mesh, 0.1);
  for (const int node : mesh::panel_nodes(mesh, "attachment"))
    EXPECT_TRUE(nodes.col(node) == mesh.nodes.col(node));
  EXPECT_EQ(nodes.row(0).maxCoeff(), 0.1 * mesh.nodes.row(0).maxCoeff());
  EXPECT_TRUE(nodes.bottomRows(2) == mesh.nodes.bottomRows(2));
}

// x -> f x multiplies the volume by f and every triple product with it: 2744 terms, 20 operations each.
TEST(Flattening, volume_scales_with_the_factor) {
  const Mesh mesh = mesh::passenger_bag().mesh;
  const double design = mesh::enclosed_volume(mesh.nodes, mesh.elements);
  for (const double factor : {1.0, 0.5, 0.1, 0.01})
    EXPECT_NEAR(mesh::enclosed_volume(mesh::flatten(mesh, factor), mesh.elements) / design, factor,
                2744 * 20 * 2.3e-16 * factor);
}

// Convex-like shape: seen from the mid-point every element keeps its side, so that none is inverted.
TEST(Flattening, no_element_is_inverted) {
  const Mesh mesh = mesh::passenger_bag().mesh;
  for (const double factor : {1.0, 0.1, 0.02}) {
    const Eigen::Matrix3Xd nodes = mesh::flatten(mesh, factor);
    EXPECT_TRUE(mesh::check_closed_surface(nodes, mesh.elements).ok());
    const Eigen::Vector3d middle(factor * 0.34, 0.0, 0.0);
    for (int e = 0; e < mesh.element_count(); ++e) {
      const Eigen::Vector3d a = nodes.col(mesh.elements(0, e)) - middle,
                            b = nodes.col(mesh.elements(1, e)) - middle;
      EXPECT_GT(a.dot(b.cross(nodes.col(mesh.elements(2, e)) - middle)), 0.0) << e;
    }
  }
}

TEST(Flattening, no_two_elements_intersect) {
  const Mesh mesh = mesh::passenger_bag().mesh;
  for (const double factor : {1.0, 0.1})
    EXPECT_EQ(intersecting_pairs(mesh::flatten(mesh, factor), mesh.elements), 0) << factor;
}

TEST(Flattening, the_intersection_check_sees_a_folded_shape) {
  Mesh mesh = mesh::passenger_bag().mesh;
  const int front = mesh::passenger_bag().strap_anchors[0][1];
  mesh.nodes(0, front) = -0.01;  // pushed through the back
  EXPECT_GT(intersecting_pairs(mesh.nodes, mesh.elements), 0);
  Mesh sphere = mesh::icosphere(1.0, 1);
  sphere.nodes.col(0) *= -1.1;  // through the opposite side: only elements apart or with a common node meet
  EXPECT_GT(intersecting_pairs(sphere.nodes, sphere.elements), 0);
  Mesh sheet = mesh::rectangle(1, 1, 1.0, 1.0, mesh::Diagonals::uniform);
  EXPECT_EQ(intersecting_pairs(sheet.nodes, sheet.elements), 0);
  sheet.nodes.col(2) << 0.75, 0.25, 0.0;  // folded flat along the common edge
  EXPECT_EQ(intersecting_pairs(sheet.nodes, sheet.elements), 1);
}

TEST(Flattening, factors_outside_zero_to_one_are_refused) {
  const Mesh mesh = mesh::icosphere(1.0, 0);
  for (const double factor : {0.0, -0.1, 1.5, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(mesh::flatten(mesh, factor), std::invalid_argument);
}

}  // namespace
