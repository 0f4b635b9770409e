// SPDX-License-Identifier: Apache-2.0
// Every fault of a control volume's surface is found, and only that fault is reported.
#include "mesh/surface_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "mesh/icosphere.hpp"

namespace {

using mesh::check_closed_surface;
using mesh::Mesh;
using mesh::SurfaceReport;

Mesh two_spheres(double distance) {
  const Mesh sphere = mesh::icosphere(1.0, 1);
  Mesh both = sphere;
  both.nodes.resize(3, 2 * sphere.node_count());
  both.nodes << sphere.nodes, sphere.nodes.colwise() + Eigen::Vector3d(distance, 0.0, 0.0);
  both.elements.resize(3, 2 * sphere.element_count());
  both.elements << sphere.elements, (sphere.elements.array() + sphere.node_count()).matrix();
  return both;
}

void replace_node(Mesh& mesh, int from, int to) {
  for (int& node : mesh.elements.reshaped())
    if (node == from) node = to;
}

void append_copy_of_element(Mesh& mesh, int element) {
  const Eigen::Matrix3Xi old = mesh.elements;
  mesh.elements.resize(3, old.cols() + 1);
  mesh.elements << old, old.middleCols(element, 1);
}

SurfaceReport check(const Mesh& mesh) {
  return check_closed_surface(mesh.nodes, mesh.elements);
}

TEST(SurfaceCheck, closed_surface_has_no_fault) {
  for (const int level : {0, 1, 3}) {
    const SurfaceReport report = check(mesh::icosphere(0.3, level));
    EXPECT_TRUE(report.ok()) << report.describe();
    EXPECT_EQ(report.describe(), "");
    EXPECT_GT(report.volume, 0.0);
  }
}

TEST(SurfaceCheck, hole_is_three_boundary_edges) {
  Mesh mesh = mesh::icosphere(1.0, 2);
  const Eigen::Vector3i removed = mesh.elements.col(7);
  mesh.elements.col(7) = mesh.elements.rightCols(1);
  mesh.elements.conservativeResize(3, mesh.elements.cols() - 1);
  const SurfaceReport report = check(mesh);
  ASSERT_EQ(report.boundary_edges.size(), 3u);
  for (const auto& edge : report.boundary_edges) {
    EXPECT_EQ(edge.elements.size(), 1u);
    for (const int node : edge.nodes) EXPECT_TRUE((removed.array() == node).any());
  }
  EXPECT_TRUE(report.inconsistent_edges.empty() && report.non_manifold_edges.empty());
  EXPECT_TRUE(report.pinched_nodes.empty() && report.components.empty());
  EXPECT_NE(report.describe().find("3 boundary edges"), std::string::npos) << report.describe();
}

TEST(SurfaceCheck, flipped_element_is_three_inconsistent_edges) {
  Mesh mesh = mesh::icosphere(1.0, 2);
  std::swap(mesh.elements(0, 11), mesh.elements(1, 11));
  const SurfaceReport report = check(mesh);
  ASSERT_EQ(report.inconsistent_edges.size(), 3u);
  for (const auto& edge : report.inconsistent_edges)
    EXPECT_TRUE(edge.elements[0] == 11 || edge.elements[1] == 11);
  EXPECT_TRUE(report.boundary_edges.empty() && report.non_manifold_edges.empty());
  EXPECT_FALSE(report.ok());
}

TEST(SurfaceCheck, duplicated_element_is_three_non_manifold_edges) {
  Mesh mesh = mesh::icosphere(1.0, 2);
  append_copy_of_element(mesh, 5);
  const SurfaceReport report = check(mesh);
  ASSERT_EQ(report.non_manifold_edges.size(), 3u);
  const std::vector<int>& sharing = report.non_manifold_edges[0].elements;
  ASSERT_EQ(sharing.size(), 3u);
  EXPECT_TRUE(std::count(sharing.begin(), sharing.end(), 5) == 1);
  EXPECT_TRUE(std::count(sharing.begin(), sharing.end(), mesh.element_count() - 1) == 1);
  EXPECT_TRUE(report.boundary_edges.empty() && report.inconsistent_edges.empty());
}

TEST(SurfaceCheck, inner_wall_of_two_chambers_is_non_manifold) {
  Mesh mesh;  // two tetrahedra sharing the wall 0-1-2, the wall kept
  mesh.nodes.resize(3, 5);
  mesh.nodes << 0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 0, 1, -1;
  mesh.elements.resize(3, 7);
  mesh.elements << 0, 1, 2, 1, 2, 0, 0, 1, 2, 0, 0, 1, 2, 1, 3, 3, 3, 4, 4, 4, 2;
  EXPECT_EQ(check(mesh).non_manifold_edges.size(), 3u);
  EXPECT_NE(check(mesh).describe().find("chambers"), std::string::npos);
}

TEST(SurfaceCheck, two_components_are_named_by_their_elements) {
  const Mesh mesh = two_spheres(5.0);
  const SurfaceReport report = check(mesh);
  ASSERT_EQ(report.components.size(), 2u);
  EXPECT_EQ(report.components[0].size(), 80u);
  EXPECT_EQ(report.components[1].front(), 80);
  EXPECT_TRUE(report.boundary_edges.empty() && report.pinched_nodes.empty());
  EXPECT_FALSE(report.ok());
}

TEST(SurfaceCheck, spheres_sharing_a_node_are_pinched_there) {
  Mesh mesh = two_spheres(2.0);
  const int kept = 3, dropped = 42 + 3;  // icosphere(1, 1) has 42 nodes
  replace_node(mesh, dropped, kept);
  const SurfaceReport report = check(mesh);
  EXPECT_EQ(report.pinched_nodes, std::vector<int>{kept});
  EXPECT_EQ(report.components.size(), 2u);
  EXPECT_EQ(report.unused_nodes, std::vector<int>{dropped});
}

TEST(SurfaceCheck, node_pinched_within_one_component_is_found) {
  Mesh mesh = mesh::icosphere(1.0, 2);  // node 0 and the opposite node 3 merged
  replace_node(mesh, 3, 0);
  const SurfaceReport report = check(mesh);
  EXPECT_EQ(report.pinched_nodes, std::vector<int>{0});
  EXPECT_TRUE(report.components.empty() && report.boundary_edges.empty());
  EXPECT_FALSE(report.ok());
}

TEST(SurfaceCheck, sheets_on_each_other_are_flat_not_inward) {
  Mesh mesh = mesh::icosphere(0.3, 3);
  mesh.nodes.row(2).setConstant(0.2);
  const SurfaceReport report = check(mesh);
  EXPECT_TRUE(report.flat);
  EXPECT_FALSE(report.ok());
  EXPECT_EQ(report.describe(), "no volume: the sheets lie on each other; give an open initial shape\n");
  EXPECT_FALSE(check(mesh::icosphere(0.3, 3)).flat);
}

TEST(SurfaceCheck, inward_orientation_is_negative_volume) {
  Mesh mesh = mesh::icosphere(1.0, 2);
  const double outward = check(mesh).volume;
  mesh.elements.row(0).swap(mesh.elements.row(1));
  const SurfaceReport report = check(mesh);
  EXPECT_TRUE(report.inward);
  EXPECT_TRUE(report.inconsistent_edges.empty());
  // The same 320 terms of the same sign with opposite sign each, in the same order: equal but for rounding of
  // each triple product, 320 terms x 10 operations x eps.
  EXPECT_NEAR(report.volume, -outward, 3200 * std::numeric_limits<double>::epsilon());
}

TEST(SurfaceCheck, index_faults_name_the_element) {
  Mesh mesh = mesh::icosphere(1.0, 1);
  mesh.elements(1, 4) = mesh.node_count();
  mesh.elements(2, 9) = -1;
  EXPECT_EQ(check(mesh).out_of_range_elements, (std::vector<int>{4, 9}));

  mesh = mesh::icosphere(1.0, 1);
  mesh.elements(1, 4) = mesh.elements(0, 4);
  EXPECT_EQ(check(mesh).repeated_node_elements, std::vector<int>{4});
  EXPECT_FALSE(check(mesh).ok());
}

TEST(SurfaceCheck, unused_and_non_finite_nodes_are_named) {
  Mesh mesh = mesh::icosphere(1.0, 1);
  mesh.nodes.conservativeResize(3, 43);
  mesh.nodes.col(42).setZero();
  EXPECT_EQ(check(mesh).unused_nodes, std::vector<int>{42});
  mesh.nodes(2, 42) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(check(mesh).non_finite_nodes, std::vector<int>{42});
}

TEST(SurfaceCheck, empty_surface_is_refused) {
  EXPECT_TRUE(check(Mesh{}).empty);
  EXPECT_FALSE(check(Mesh{}).ok());
}

TEST(SurfaceCheck, require_throws_with_the_description) {
  Mesh mesh = mesh::icosphere(1.0, 0);
  EXPECT_NO_THROW(mesh::require_closed_surface(mesh.nodes, mesh.elements));
  mesh.elements.col(0) = mesh.elements.col(1);
  try {
    mesh::require_closed_surface(mesh.nodes, mesh.elements);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(check(mesh).describe()), std::string::npos);
  }
}

}  // namespace
