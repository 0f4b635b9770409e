// SPDX-License-Identifier: Apache-2.0
// The generated passenger bag: counts, panels, symmetry, element quality, refused options.
#include "mesh/passenger_bag.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "mesh/surface_check.hpp"

namespace {

using mesh::Mesh;
using mesh::passenger_bag;
using mesh::PassengerBagOptions;
using Element = std::set<int>;

// Node at the mirror image about y = 0, or -1; the generator mirrors bit for bit.
std::vector<int> mirror_nodes(const Mesh& mesh) {
  std::map<std::array<double, 3>, int> at;
  for (int i = 0; i < mesh.node_count(); ++i) at[{mesh.nodes(0, i), mesh.nodes(1, i), mesh.nodes(2, i)}] = i;
  std::vector<int> mirror;
  for (int i = 0; i < mesh.node_count(); ++i) {
    const auto found = at.find({mesh.nodes(0, i), -mesh.nodes(1, i), mesh.nodes(2, i)});
    mirror.push_back(found == at.end() ? -1 : found->second);
  }
  return mirror;
}

std::set<Element> element_sets(const Mesh& mesh) {
  std::set<Element> sets;
  for (int e = 0; e < mesh.element_count(); ++e)
    sets.insert({mesh.elements(0, e), mesh.elements(1, e), mesh.elements(2, e)});
  return sets;
}

TEST(PassengerBag, default_has_exactly_2744_elements) {
  const Mesh mesh = passenger_bag().mesh;
  EXPECT_EQ(mesh.element_count(), 2744);
  EXPECT_EQ(mesh.node_count(), 1374);  // Euler: N - M / 2 = 2
  EXPECT_EQ(mesh.panel.size(), 2744u);
}

TEST(PassengerBag, surface_is_a_closed_control_volume_for_any_cells) {
  for (const auto& [depth, width, height] : {std::array{22, 8, 17}, {4, 6, 7}, {10, 12, 8}, {31, 12, 23}}) {
    PassengerBagOptions options;
    options.depth_cells = depth;
    options.width_cells = width;
    options.height_cells = height;
    options.attachment_height_cells = height % 2 ? 1 : 2;
    options.vent_depth_cell = 1;
    options.vent_height_cell = 1;
    const Mesh mesh = passenger_bag(options).mesh;
    EXPECT_EQ(mesh.element_count(), 4 * (depth * width + width * height + height * depth));
    const auto report = mesh::check_closed_surface(mesh.nodes, mesh.elements);
    EXPECT_TRUE(report.ok()) << report.describe();
  }
}

TEST(PassengerBag, panels_partition_the_elements) {
  const Mesh mesh = passenger_bag().mesh;
  EXPECT_EQ(mesh::panel_elements(mesh, "main").size(), 2u * (78 * 8 - 6 * 5));
  EXPECT_EQ(mesh::panel_elements(mesh, "side_left").size(), 2u * 22 * 17);
  EXPECT_EQ(mesh::panel_elements(mesh, "side_right").size(), 2u * 22 * 17 - 4);
  EXPECT_EQ(mesh::panel_elements(mesh, "attachment").size(), 2u * 6 * 5);
  EXPECT_EQ(mesh::panel_elements(mesh, "vent").size(), 4u);
  EXPECT_TRUE(std::is_sorted(mesh.panel.begin(), mesh.panel.end()));
}

TEST(PassengerBag, attachment_lies_exactly_in_the_plane_round_the_outlet) {
  const Mesh mesh = passenger_bag().mesh;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const int node : mesh::panel_nodes(mesh, "attachment")) {
    EXPECT_EQ(mesh.nodes(0, node), 0.0);
    centre += mesh.nodes.col(node);
  }
  EXPECT_EQ(mesh::panel_nodes(mesh, "attachment").size(), 42u);
  EXPECT_LT(centre.norm(), 42 * 1e-16);  // 42 terms below 0.1 m that cancel in mirrored pairs
  EXPECT_GE(mesh.nodes.row(0).minCoeff(), 0.0);
}

TEST(PassengerBag, side_panels_are_plane) {
  const Mesh mesh = passenger_bag().mesh;
  for (const int node : mesh::panel_nodes(mesh, "side_left")) EXPECT_EQ(mesh.nodes(1, node), -0.125);
  for (const int node : mesh::panel_nodes(mesh, "side_right")) EXPECT_EQ(mesh.nodes(1, node), 0.125);
}

// A flat cut exists: each strip of the main panel between two generators is a plane rectangle, so that no
// normal of the panel has a y component.
TEST(PassengerBag, main_panel_is_a_cylinder_along_y) {
  const Mesh mesh = passenger_bag().mesh;
  for (const char* panel : {"main", "attachment"})
    for (const int e : mesh::panel_elements(mesh, panel)) {
      const Eigen::Vector3d a = mesh.nodes.col(mesh.elements(0, e)), b = mesh.nodes.col(mesh.elements(1, e));
      const Eigen::Vector3d c = mesh.nodes.col(mesh.elements(2, e));
      EXPECT_EQ((b - a).cross(c - a).y(), 0.0);  // products of equal (x, z) differences: exact
    }
}

TEST(PassengerBag, vent_is_six_rim_nodes_held_by_fabric) {
  const Mesh mesh = passenger_bag().mesh;
  const std::vector<int> elements = mesh::panel_elements(mesh, "vent");
  std::map<std::pair<int, int>, int> edges;
  for (const int e : elements)
    for (int i = 0; i < 3; ++i) ++edges[std::minmax(mesh.elements(i, e), mesh.elements((i + 1) % 3, e))];
  std::set<int> rim;
  for (const auto& [edge, count] : edges)
    if (count == 1) rim.insert({edge.first, edge.second});
  const std::vector<int> nodes = mesh::panel_nodes(mesh, "vent");
  EXPECT_EQ(nodes.size(), 6u);
  EXPECT_EQ(std::vector<int>(rim.begin(), rim.end()), nodes);
  const std::vector<int> fabric = mesh::panel_nodes(mesh, "side_right");
  for (const int node : nodes) EXPECT_TRUE(std::binary_search(fabric.begin(), fabric.end(), node));
  const Eigen::VectorXd areas = mesh::element_areas(mesh.nodes, mesh.elements);
  double area = 0.0;
  for (const int e : elements) area += areas(e);
  EXPECT_NEAR(area, 1.9e-3, 0.05e-3);  // [m2] two cells of 3 cm: what the documentation says
}

TEST(PassengerBag, nodes_and_elements_mirror_about_the_mid_plane) {
  const Mesh mesh = passenger_bag().mesh;
  const std::vector<int> mirror = mirror_nodes(mesh);
  EXPECT_EQ(std::count(mirror.begin(), mirror.end(), -1), 0);
  const std::set<Element> elements = element_sets(mesh);
  int missing = 0;
  for (const Element& element : elements) {
    Element image;
    for (const int node : element) image.insert(mirror[static_cast<std::size_t>(node)]);
    missing += elements.count(image) == 0;
  }
  EXPECT_EQ(missing, 0);
}

TEST(PassengerBag, nodes_mirror_about_the_horizontal_plane) {
  Mesh mesh = passenger_bag().mesh;
  mesh.nodes.row(1).swap(mesh.nodes.row(2));
  const std::vector<int> mirror = mirror_nodes(mesh);
  EXPECT_EQ(std::count(mirror.begin(), mirror.end(), -1), 0);
}

TEST(PassengerBag, straps_join_the_attachment_edges_to_the_front_at_the_same_height) {
  const mesh::PassengerBag bag = passenger_bag();
  const std::vector<int> attachment = mesh::panel_nodes(bag.mesh, "attachment");
  double heights = 0.0;
  for (const auto& [back, front] : bag.strap_anchors) {
    const Eigen::Vector3d a = bag.mesh.nodes.col(back), b = bag.mesh.nodes.col(front);
    EXPECT_TRUE(std::binary_search(attachment.begin(), attachment.end(), back));
    EXPECT_EQ(a.y(), 0.0);
    EXPECT_EQ(b.y(), 0.0);
    EXPECT_NEAR(a.z(), b.z(), 1e-15);  // two arc lengths of 1 m that differ by half the perimeter: eps of 1 m
    EXPECT_NEAR(b.x() - a.x(), 0.68, 1e-15);
    heights += a.z();
  }
  EXPECT_GT(bag.mesh.nodes(2, bag.strap_anchors[0][0]), 0.05);
  EXPECT_EQ(heights, 0.0);
}

// Figures of the default mesh; the smallest altitude governs the time step, so it must stay near the mean.
TEST(PassengerBag, elements_are_well_shaped) {
  const Mesh mesh = passenger_bag().mesh;
  const mesh::ElementQuality q = mesh::element_quality(mesh.nodes, mesh.elements);
  EXPECT_GT(q.min_altitude, 0.8 * q.mean_altitude);
  EXPECT_GT(q.min_altitude, 0.0185);
  EXPECT_GT(q.min_angle, 38.0 * EIGEN_PI / 180.0);
  EXPECT_LT(q.max_aspect, 2.2);
}

struct BadOption {
  const char* field;
  void (*change)(PassengerBagOptions&);
};

TEST(PassengerBag, bad_options_are_refused_by_name) {
  const BadOption bad[] = {
      {"depth", [](PassengerBagOptions& o) { o.depth = 0.0; }},
      {"width", [](PassengerBagOptions& o) { o.width = -1.0; }},
      {"height", [](PassengerBagOptions& o) { o.height = std::nan(""); }},
      {"back_radius", [](PassengerBagOptions& o) { o.back_radius = 0.3; }},
      {"front_radius", [](PassengerBagOptions& o) { o.front_radius = INFINITY; }},
      {"front_radius", [](PassengerBagOptions& o) { o.front_radius = 0.28; }},
      {"back_radius + front_radius", [](PassengerBagOptions& o) { o.depth = 0.12; }},
      {"depth_cells", [](PassengerBagOptions& o) { o.depth_cells = 3; }},
      {"depth_cells", [](PassengerBagOptions& o) { o.depth_cells = 101; }},
      {"width_cells", [](PassengerBagOptions& o) { o.width_cells = 9; }},
      {"height_cells", [](PassengerBagOptions& o) { o.height_cells = -17; }},
      {"attachment_width_cells", [](PassengerBagOptions& o) { o.attachment_width_cells = 10; }},
      {"attachment_width_cells", [](PassengerBagOptions& o) { o.attachment_width_cells = 3; }},
      {"attachment_height_cells", [](PassengerBagOptions& o) { o.attachment_height_cells = 4; }},
      {"attachment_height_cells", [](PassengerBagOptions& o) { o.attachment_height_cells = 17; }},
      {"vent_depth_cell", [](PassengerBagOptions& o) { o.vent_depth_cell = 20; }},
      {"vent_height_cell", [](PassengerBagOptions& o) { o.vent_height_cell = 0; }},
  };
  for (const BadOption& option : bad) {
    PassengerBagOptions options;
    option.change(options);
    try {
      passenger_bag(options);
      ADD_FAILURE() << "accepted a bad " << option.field;
    } catch (const std::invalid_argument& error) {
      const std::string expected = "passenger_bag: " + std::string(option.field) + " = ";
      EXPECT_EQ(std::string(error.what()).rfind(expected, 0), 0u) << error.what();
    }
  }
}

}  // namespace
