// SPDX-License-Identifier: Apache-2.0
// Nodes that lie on each other become one; polygons become a mesh.
#include "mesh/merge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "mesh/icosphere.hpp"
#include "mesh/polygons.hpp"
#include "mesh/surface_check.hpp"
#include "same_mesh.hpp"

namespace merging {
namespace {

using mesh::Mesh;

// Each triangle with corners of its own, each of them off by at most `off` in every direction.
Mesh torn(const Mesh& mesh, double off) {
  Mesh result = mesh;
  result.nodes.resize(3, 3 * mesh.elements.cols());
  for (Eigen::Index i = 0; i < result.nodes.cols(); ++i) {
    result.nodes.col(i) = mesh.nodes.col(mesh.elements(i % 3, i / 3));
    for (int c = 0; c < 3; ++c)
      result.nodes(c, i) += off * (static_cast<double>(i * (31 + 7 * c) % 997) / 498.5 - 1.0);
    result.elements(i % 3, i / 3) = static_cast<int>(i);
  }
  return result;
}

TEST(Merge, torn_sphere_is_whole_again) {
  const Mesh sphere = mesh::icosphere(0.3, 3);
  for (const double off : {0.0, 1e-7}) {
    Mesh mesh = torn(sphere, off);
    EXPECT_FALSE(mesh::check_closed_surface(mesh.nodes, mesh.elements).ok());
    const auto report = mesh::merge_nodes(mesh, off * 4.0);  // two corners are at most 2 sqrt(3) off apart
    EXPECT_EQ(report.nodes, 3 * 1280 - sphere.node_count());
    EXPECT_EQ(report.elements, 0);
    EXPECT_EQ(mesh.node_count(), sphere.node_count());
    EXPECT_TRUE(mesh::check_closed_surface(mesh.nodes, mesh.elements).ok());
  }
}

TEST(Merge, nodes_farther_apart_stay) {
  Mesh mesh = torn(mesh::icosphere(0.3, 1), 1e-5);
  const Mesh before = mesh;
  EXPECT_EQ(mesh::merge_nodes(mesh, 1e-9).nodes, 0);
  meshes::expect_same_bits(mesh, before);
}

// Whichever cubes of the search they lie in, and on both sides of the coordinate planes.
TEST(Merge, distance_alone_decides) {
  for (const double at : {0.0, 1.0, -1.0, 0.999999, -0.5})
    for (const double apart : {0.9999e-3, 1.0001e-3}) {
      Mesh mesh;
      mesh.nodes.resize(3, 4);
      mesh.nodes << at, 5.0, 0.0, at + apart, at, 0.0, 5.0, at, at, 0.0, 0.0, at;
      mesh.elements.resize(3, 2);
      mesh.elements << 0, 3, 1, 1, 2, 2;
      mesh.panel = {0, 0};
      mesh.panel_names = {"default"};
      EXPECT_EQ(mesh::merge_nodes(mesh, 1e-3).nodes, apart < 1e-3 ? 1 : 0) << at << " " << apart;
    }
}

TEST(Merge, elements_that_lose_a_corner_are_left_out) {
  Mesh mesh = mesh::icosphere(1.0, 0);
  mesh.line.resize(20);
  mesh.nodes.col(mesh.elements(1, 0)) = mesh.nodes.col(mesh.elements(0, 0));
  const auto report = mesh::merge_nodes(mesh, 0.0);
  EXPECT_EQ(report.nodes, 1);
  EXPECT_EQ(report.elements, 2);  // both sides of the edge
  EXPECT_EQ(mesh.element_count(), 18);
  EXPECT_EQ(mesh.panel.size(), 18u);
  EXPECT_EQ(mesh.line.size(), 18u);
  EXPECT_TRUE(mesh::check_closed_surface(mesh.nodes, mesh.elements).ok());
}

// Each edge in turn becomes a point: both elements beside it go, and the sphere stays closed.
TEST(Collapsed, elements_with_two_corners_in_one_place_are_left_out) {
  const Mesh sphere = mesh::icosphere(1.0, 1);
  for (int e = 0; e < sphere.element_count(); ++e)
    for (int a = 0; a < 3; ++a) {
      Mesh mesh = sphere;
      const int keeps = mesh.elements(a, e), goes = mesh.elements((a + 1) % 3, e);
      mesh.nodes.col(goes) = mesh.nodes.col(keeps);
      Eigen::Matrix3Xd start = 2.0 * sphere.nodes;
      EXPECT_EQ(mesh::drop_collapsed(mesh, &start), 2);
      EXPECT_EQ(mesh.element_count(), 78);
      EXPECT_EQ(mesh.panel.size(), 78u);
      EXPECT_EQ(mesh.node_count(), 41);
      ASSERT_EQ(start.cols(), 41);
      for (int n = 0, old = 0; n < 41; ++n, ++old) {
        if (old == std::max(keeps, goes)) ++old;
        EXPECT_TRUE(start.col(n) == 2.0 * sphere.nodes.col(old));
      }
      EXPECT_TRUE(mesh::check_closed_surface(mesh.nodes, mesh.elements).ok());
    }
}

TEST(Collapsed, a_repeated_corner_goes_and_its_other_nodes_with_it) {
  Mesh mesh = mesh::icosphere(1.0, 0);
  const Mesh whole = mesh;
  mesh.nodes.conservativeResize(3, 14);
  mesh.nodes.col(12) << 5.0, 0.0, 0.0;  // of the spike alone
  mesh.nodes.col(13) << 6.0, 0.0, 0.0;  // of no element before: stays
  mesh.elements.conservativeResize(3, 22);
  mesh.elements.col(20) << 4, 12, 4;
  mesh.elements.col(21) << 7, 7, 7;
  mesh.panel.resize(22, 0);
  EXPECT_EQ(mesh::drop_collapsed(mesh), 2);
  EXPECT_TRUE(mesh.elements == whole.elements);
  EXPECT_TRUE(mesh.nodes.leftCols(12) == whole.nodes);
  EXPECT_EQ(mesh.node_count(), 13);
}

// Nodes of one place that no element joins are those of a seam: they stay apart.
TEST(Collapsed, nothing_else_changes) {
  for (Mesh mesh : {torn(mesh::icosphere(0.3, 2), 0.0), mesh::icosphere(0.3, 2)}) {
    const Mesh before = mesh;
    EXPECT_EQ(mesh::drop_collapsed(mesh), 0);
    meshes::expect_same_bits(mesh, before);
  }
}

// However many: a sheet that is one point.
TEST(Collapsed, all_elements_may_go) {
  Mesh mesh = mesh::icosphere(1.0, 6);
  mesh.nodes.setConstant(0.5);
  EXPECT_EQ(mesh::drop_collapsed(mesh), 20 * 4096);
  EXPECT_EQ(mesh.element_count(), 0);
  EXPECT_EQ(mesh.node_count(), 0);
}

TEST(Merge, bad_tolerances_and_nodes_are_refused) {
  Mesh mesh = mesh::icosphere(1.0, 0);
  for (const double bad : {-1.0, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_THROW(mesh::merge_nodes(mesh, bad), std::invalid_argument);
  EXPECT_THROW(mesh::merge_nodes(mesh, 1e-300), std::invalid_argument);
  mesh.nodes(0, 3) = std::nan("");
  EXPECT_THROW(mesh::merge_nodes(mesh, 0.0), std::invalid_argument);
  EXPECT_THROW(mesh::merge_nodes(mesh, 0.1), std::invalid_argument);
}

TEST(Polygons, quads_are_split_and_unused_nodes_left_out) {
  Eigen::Matrix3Xd nodes(3, 6);
  nodes << 9, 0, 1, 2, 1, 0, 9, 0, 0, 1, 1, 5, 9, 0, 0, 0, 0, 5;
  const Mesh mesh = mesh::mesh_of_polygons(nodes, {{1, 2, 3, 4}, {1, 4, 5}});
  EXPECT_EQ(mesh.node_count(), 5);
  EXPECT_EQ(mesh.split_quads, 1);
  EXPECT_TRUE(mesh.elements == (Eigen::Matrix3Xi(3, 3) << 1, 1, 0, 2, 3, 3, 3, 0, 4).finished());
  EXPECT_TRUE(mesh.line.empty());
}

// Two square sheets of n x n quads that bulge apart; with seams of their own, or in common.
std::pair<Eigen::Matrix3Xd, std::vector<std::vector<int>>> pillow(int n, bool own_seams) {
  const int of_sheet = (n + 1) * (n + 1);
  Eigen::Matrix3Xd nodes(3, 2 * of_sheet);
  const auto node = [&](int sheet, int i, int j) {
    const bool seam = i == 0 || j == 0 || i == n || j == n;
    return (seam && !own_seams ? 0 : sheet * of_sheet) + i * (n + 1) + j;
  };
  std::vector<std::vector<int>> quads;
  for (int sheet = 0; sheet < 2; ++sheet)
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) {
        const double x = 2.0 * i / n - 1.0, y = 2.0 * j / n - 1.0;
        nodes.col(sheet * of_sheet + i * (n + 1) + j) << x, y,
            (sheet == 0 ? 0.3 : -0.3) * (1.0 - x * x) * (1.0 - y * y);
        if (i == n || j == n) continue;
        quads.push_back(
            {node(sheet, i, j), node(sheet, i + 1, j), node(sheet, i + 1, j + 1), node(sheet, i, j + 1)});
        if (sheet == 1) std::reverse(quads.back().begin(), quads.back().end());
      }
  return {nodes, quads};
}

// In each corner both sheets have the diagonal between two nodes of the seam for their shorter one.
TEST(Polygons, two_sheets_of_quads_are_closed) {
  for (const bool own_seams : {false, true})
    for (const int n : {2, 3, 8}) {
      const auto [nodes, quads] = pillow(n, own_seams);
      const auto side = [&, x = nodes](int a, int b) { return (x.col(a) - x.col(b)).norm(); };
      ASSERT_LT(side(quads[0][1], quads[0][3]), side(quads[0][0], quads[0][2]));
      Mesh mesh = mesh::mesh_of_polygons(nodes, quads);
      EXPECT_EQ(mesh.split_quads, 2 * n * n);
      mesh::merge_nodes(mesh, 0.0);
      const auto report = mesh::check_closed_surface(mesh.nodes, mesh.elements);
      EXPECT_TRUE(report.ok()) << report.describe();
    }
}

TEST(Polygons, bad_ones_are_named) {
  const Eigen::Matrix3Xd nodes = mesh::icosphere(1.0, 0).nodes;
  const auto message = [&](std::vector<std::vector<int>> polygons, const Eigen::Matrix3Xd& x) -> std::string {
    try {
      mesh::mesh_of_polygons(x, polygons);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(message({{0, 1, 2}}, nodes), "accepted");
  EXPECT_NE(message({}, nodes).find("no elements"), std::string::npos);
  EXPECT_NE(message({{0, 1, 2}, {0, 1}}, nodes).find("element 1: 2 corners"), std::string::npos);
  EXPECT_NE(message({{0, 1, 12}}, nodes).find("node 12 is out of range, 0 to 11"), std::string::npos);
  EXPECT_NE(message({{0, 1, -1}}, nodes).find("node -1 is out of range"), std::string::npos);
  EXPECT_EQ(message({{0, 1, 0}}, nodes), "accepted");  // drop_collapsed() takes it out
  Eigen::Matrix3Xd bad = nodes;
  bad(2, 4) = std::nan("");
  EXPECT_NE(message({{0, 1, 2}}, bad).find("node 4: a coordinate is not finite"), std::string::npos);
}

}  // namespace
}  // namespace merging
