// SPDX-License-Identifier: Apache-2.0
// Icosphere, rectangle and the plain geometry of a mesh.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "claim.hpp"
#include "closed_form/membrane.hpp"
#include "mesh/icosphere.hpp"
#include "mesh/surface_check.hpp"
#include "rounding.hpp"

namespace {

using mesh::Mesh;

using support::kEps;

double sphere_volume(double radius) {
  return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
}

double volume(const Mesh& mesh) {
  return mesh::enclosed_volume(mesh.nodes, mesh.elements);
}

TEST(Icosphere, volume_ratio_eq_closed_form) {
  for (int level = 0; level <= 5; ++level) {
    const Mesh mesh = mesh::icosphere(0.3, level);
    const auto exact = closed_form::icosphere_ratios(level);
    ASSERT_EQ(static_cast<std::size_t>(mesh.element_count()), exact.faces);
    const double tolerance = 20.0 * kEps * std::sqrt(static_cast<double>(exact.faces));
    const char* why = "sums of terms of one sign, random rounding: 10 eps sqrt(terms), twice for the oracle";
    claim::expect_near({"M.5", "icospheres of 20 to 20480 elements: volume over the sphere's [-]", why},
                       volume(mesh) / sphere_volume(0.3), exact.volume_ratio, tolerance);
    const double area = mesh::element_areas(mesh.nodes, mesh.elements).sum();
    claim::expect_near({"M.5", "icospheres of 20 to 20480 elements: area over the sphere's [-]", why},
                       area / (4.0 * std::numbers::pi * 0.09), exact.area_ratio, tolerance);
  }
}

TEST(Icosphere, volume_converges_at_order_two) {
  std::vector<double> defects;
  for (int level = 2; level <= 6; ++level)
    defects.push_back(1.0 - volume(mesh::icosphere(1.0, level)) / sphere_volume(1.0));
  claim::expect_order({"M.5", "icospheres of 320 to 81920 elements: volume",
                       "ratios of successive defects are 3.93 and above from 1280 elements, and tend to 4"},
                      defects, 1.97, 2.01);
}

TEST(Icosphere, nodes_lie_on_the_sphere_of_a_closed_surface) {
  for (int level = 0; level <= 4; ++level) {
    const Mesh mesh = mesh::icosphere(0.7, level);
    EXPECT_EQ(mesh.node_count(), 10 * (1 << (2 * level)) + 2);
    EXPECT_TRUE(mesh::check_closed_surface(mesh.nodes, mesh.elements).ok());
    // normalise and scale: a division, a product and a square root, and the norm here
    EXPECT_LT((mesh.nodes.colwise().norm().array() - 0.7).abs().maxCoeff(), 8.0 * 0.7 * kEps);
  }
}

TEST(Rectangle, cells_tile_the_sheet_facing_up) {
  for (const auto diagonals : {mesh::Diagonals::uniform, mesh::Diagonals::union_jack}) {
    const Mesh mesh = mesh::rectangle(6, 4, 3.0, 1.0, diagonals);
    ASSERT_EQ(mesh.element_count(), 48);
    ASSERT_EQ(mesh.node_count(), 35);
    const Eigen::VectorXd areas = mesh::element_areas(mesh.nodes, mesh.elements);
    EXPECT_LT((areas.array() - 3.0 / 48.0).abs().maxCoeff(),
              16.0 * kEps);  // a few roundings of numbers near 1
    for (int e = 0; e < 48; ++e) {
      const Eigen::Vector3d a = mesh.nodes.col(mesh.elements(0, e));
      const Eigen::Vector3d u = mesh.nodes.col(mesh.elements(1, e)) - a,
                            v = mesh.nodes.col(mesh.elements(2, e)) - a;
      EXPECT_GT(u.x() * v.y() - u.y() * v.x(), 0.0);
    }
    const auto report = mesh::check_closed_surface(mesh.nodes, mesh.elements);
    EXPECT_EQ(report.boundary_edges.size(), 20u);
    EXPECT_TRUE(report.inconsistent_edges.empty() && report.components.empty() &&
                report.pinched_nodes.empty());
  }
}

TEST(Rectangle, union_jack_diagonals_alternate) {
  const Mesh mesh = mesh::rectangle(4, 4, 1.0, 1.0, mesh::Diagonals::union_jack);
  Eigen::VectorXi valence = Eigen::VectorXi::Zero(25);
  for (const int node : mesh.elements.reshaped()) ++valence(node);
  for (const int node : {6, 8, 12, 16, 18}) EXPECT_EQ(valence(node), 8) << node;
  for (const int node : {7, 11, 13, 17}) EXPECT_EQ(valence(node), 4) << node;
}

TEST(Generators, bad_arguments_are_refused) {
  EXPECT_THROW(mesh::icosphere(0.0, 1), std::invalid_argument);
  EXPECT_THROW(mesh::icosphere(std::nan(""), 1), std::invalid_argument);
  EXPECT_THROW(mesh::icosphere(1.0, -1), std::invalid_argument);
  EXPECT_THROW(mesh::icosphere(1.0, 10), std::invalid_argument);
  const auto uniform = mesh::Diagonals::uniform;
  EXPECT_THROW(mesh::rectangle(0, 1, 1.0, 1.0, uniform), std::invalid_argument);
  EXPECT_THROW(mesh::rectangle(1, -1, 1.0, 1.0, uniform), std::invalid_argument);
  EXPECT_THROW(mesh::rectangle(1, 1, 0.0, 1.0, uniform), std::invalid_argument);
  EXPECT_THROW(mesh::rectangle(1, 1, 1.0, INFINITY, uniform), std::invalid_argument);
}

// A translation by 1e6 rounds each coordinate by 1e6 eps / 2 = 1.1e-10; the volume moves by that times the
// area (12.5).
TEST(MeshGeometry, volume_is_independent_of_the_origin) {
  const Mesh mesh = mesh::icosphere(1.0, 3);
  const double at_origin = volume(mesh);
  for (const double shift : {1.0, 1e3, 1e6}) {
    Mesh moved = mesh;
    moved.nodes.colwise() += Eigen::Vector3d(shift, -0.5 * shift, 0.25 * shift);
    EXPECT_NEAR(volume(moved), at_origin, 12.5 * shift * kEps + 1e3 * kEps) << shift;
  }
}

TEST(MeshGeometry, quality_of_known_triangles) {
  Mesh mesh;
  mesh.nodes.resize(3, 4);
  mesh.nodes << 0, 4, 0, 2, 0, 0, 3, 2.0 * std::sqrt(3.0), 0, 0, 0, 0;
  mesh.elements.resize(3, 1);
  mesh.elements << 0, 1, 2;  // 3-4-5
  auto q = mesh::element_quality(mesh.nodes, mesh.elements);
  EXPECT_NEAR(q.min_altitude, 2.4, 8 * kEps);  // exact integers but for one quotient
  EXPECT_NEAR(q.min_angle, std::atan(0.75), 8 * kEps);
  EXPECT_NEAR(q.max_aspect, 5.0 / 2.4, 8 * kEps);
  mesh.elements << 0, 1, 3;  // equilateral, side 4
  q = mesh::element_quality(mesh.nodes, mesh.elements);
  EXPECT_NEAR(q.min_angle, std::numbers::pi / 3.0, 8 * kEps);
  EXPECT_NEAR(q.mean_altitude, 2.0 * std::sqrt(3.0), 16 * kEps);
  mesh.elements << 0, 1, 1;
  EXPECT_THROW(mesh::element_quality(mesh.nodes, mesh.elements), std::invalid_argument);
}

// Squares of lengths of 1e120 m have no double: no such mesh has a volume.
TEST(MeshGeometry, areas_beyond_double_range_are_none) {
  const Mesh mesh = mesh::rectangle(1, 1, 1e120, 1e120, mesh::Diagonals::uniform);
  EXPECT_THROW(mesh::element_quality(mesh.nodes, mesh.elements), std::invalid_argument);
}

TEST(MeshGeometry, nearest_node_is_the_lowest_of_equals) {
  const Mesh mesh = mesh::rectangle(2, 1, 2.0, 1.0, mesh::Diagonals::uniform);
  EXPECT_EQ(mesh::nearest_node(mesh, {1.9, 0.8, 0.1}), 5);
  EXPECT_EQ(mesh::nearest_node(mesh, {0.5, 0.0, 0.0}), 0);
  EXPECT_THROW(mesh::nearest_node(Mesh{}, Eigen::Vector3d::Zero()), std::invalid_argument);
}

TEST(MeshGeometry, unknown_panel_lists_the_panels) {
  const Mesh mesh = mesh::icosphere(1.0, 0);
  EXPECT_EQ(mesh::panel_elements(mesh, "sphere").size(), 20u);
  EXPECT_EQ(mesh::panel_nodes(mesh, "sphere").size(), 12u);
  try {
    mesh::panel_index(mesh, "front");
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("\"sphere\""), std::string::npos);
  }
}

}  // namespace
