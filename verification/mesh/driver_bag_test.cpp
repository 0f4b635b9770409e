// SPDX-License-Identifier: Apache-2.0
// The driver bag: discs, panels, initial shape; uniform refinement.
#include "mesh/driver_bag.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>

#include "intersections.hpp"
#include "mesh/icosphere.hpp"
#include "mesh/passenger_bag.hpp"
#include "mesh/refine.hpp"
#include "mesh/surface_check.hpp"
#include "rounding.hpp"

namespace {

using mesh::DriverBagOptions;
using mesh::Mesh;

using support::kEps;

std::vector<DriverBagOptions> several() {
  return {{},
          {.rings = 4, .inflator_rings = 1, .vents = 0},
          {.radius = 0.3, .opening = 0.2, .rings = 9, .vents = 1, .vent_ring = 5}};
}

double area_of(const Mesh& mesh, const std::string& panel) {
  return mesh::panel_areas(mesh)(mesh::panel_index(mesh, panel));
}

TEST(DriverBag, opened_shape_is_a_closed_control_volume) {
  for (const auto& o : several()) {
    const auto bag = mesh::driver_bag(o);
    EXPECT_EQ(bag.mesh.element_count(), 12 * o.rings * o.rings);
    EXPECT_EQ(mesh::check_closed_surface(bag.opened, bag.mesh.elements).describe(), "");
    EXPECT_EQ(intersections::intersecting_pairs(bag.opened, bag.mesh.elements), 0);
  }
}

// The discs are regular polygons of 6 rings sides, plane and turned away from each other.
TEST(DriverBag, design_shape_is_two_plane_discs) {
  for (const auto& o : several()) {
    const Mesh mesh = mesh::driver_bag(o).mesh;
    EXPECT_EQ(mesh.nodes.row(0).cwiseAbs().maxCoeff(), 0.0);
    const double sides = 6.0 * o.rings;
    const double polygon = 0.5 * sides * o.radius * o.radius * std::sin(2.0 * std::numbers::pi / sides);
    EXPECT_NEAR(area_of(mesh, "front"), polygon,
                12 * o.rings * o.rings * kEps * polygon);  // a sum of that many terms
    EXPECT_NEAR(mesh::panel_areas(mesh).sum(), 2.0 * polygon, 24 * o.rings * o.rings * kEps * polygon);
    for (int e = 0; e < mesh.element_count(); ++e) {
      const Eigen::Vector3d a = mesh.nodes.col(mesh.elements(0, e));
      const Eigen::Vector3d normal = Eigen::Vector3d(mesh.nodes.col(mesh.elements(1, e)) - a)
                                         .cross(mesh.nodes.col(mesh.elements(2, e)) - a);
      EXPECT_GT(mesh.panel[static_cast<std::size_t>(e)] == 0 ? normal.x() : -normal.x(), 0.0) << e;
    }
  }
}

TEST(DriverBag, attachment_is_the_inflator_disc_and_stays) {
  const DriverBagOptions o;
  const auto bag = mesh::driver_bag(o);
  const double sides = 6.0 * o.inflator_rings;
  EXPECT_NEAR(area_of(bag.mesh, "attachment"),
              0.5 * sides * o.inflator_radius * o.inflator_radius * std::sin(2.0 * std::numbers::pi / sides),
              1e-15);
  for (const int node : mesh::panel_nodes(bag.mesh, "attachment")) {
    EXPECT_LE(bag.mesh.nodes.col(node).norm(), o.inflator_radius * (1.0 + 4 * kEps));
    EXPECT_LE((bag.opened.col(node) - bag.mesh.nodes.col(node)).norm(), 4 * kEps * o.inflator_radius);
  }
}

// No side of an element is longer than its cut, meridians keep their length, and the middles are `opening`
// apart.
TEST(DriverBag, opened_shape_stretches_nothing) {
  const DriverBagOptions o;
  const auto bag = mesh::driver_bag(o);
  for (int e = 0; e < bag.mesh.element_count(); ++e)
    for (int i = 0; i < 3; ++i) {
      const int a = bag.mesh.elements(i, e), b = bag.mesh.elements((i + 1) % 3, e);
      const double cut = (bag.mesh.nodes.col(a) - bag.mesh.nodes.col(b)).norm();
      EXPECT_LE((bag.opened.col(a) - bag.opened.col(b)).norm(),
                cut * (1.0 + 100 * kEps));  // radius over side is 14
    }
  const Eigen::RowVectorXd x = bag.opened.row(0);
  EXPECT_EQ(x.minCoeff(), 0.0);
  EXPECT_EQ(x.maxCoeff(), o.opening);
  const double rim = (bag.opened.topRows(3).colwise().norm()).maxCoeff();
  const double slope = 0.5 * o.opening / (o.radius - o.inflator_radius);
  const double across = o.inflator_radius + (o.radius - o.inflator_radius) * std::sqrt(1.0 - slope * slope);
  EXPECT_NEAR(rim, std::hypot(across, 0.5 * o.opening), 10 * kEps);
}

TEST(DriverBag, vents_are_rim_nodes_only_and_mirror_images) {
  const Mesh mesh = mesh::driver_bag().mesh;
  std::array<Eigen::Matrix3Xd, 2> centroids;
  for (int v = 0; v < 2; ++v) {
    const auto vent = mesh::panel_elements(mesh, v == 0 ? "vent_left" : "vent_right");
    ASSERT_EQ(vent.size(), 4u);
    EXPECT_EQ(mesh::panel_nodes(mesh, v == 0 ? "vent_left" : "vent_right").size(), 6u);
    auto& own = centroids[static_cast<std::size_t>(v)];
    own.resize(3, 4);
    for (int i = 0; i < 4; ++i) {
      own.col(i).setZero();
      for (int k = 0; k < 3; ++k)
        own.col(i) += mesh.nodes.col(mesh.elements(k, vent[static_cast<std::size_t>(i)])) / 3.0;
    }
  }
  EXPECT_LT(centroids[0].row(1).maxCoeff(), 0.0);
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector3d mirrored = centroids[0].col(i).cwiseProduct(Eigen::Vector3d(1.0, -1.0, 1.0));
    EXPECT_LT((centroids[1].colwise() - mirrored).colwise().norm().minCoeff(), 1e-15);  // rounding of sines
  }
}

TEST(DriverBag, tethers_join_opposite_places) {
  const auto bag = mesh::driver_bag();
  const auto rim = mesh::panel_nodes(bag.mesh, "attachment");
  for (const auto& [back, front] : bag.tether_anchors) {
    EXPECT_TRUE(std::binary_search(rim.begin(), rim.end(), back));
    EXPECT_NE(back, front);
    EXPECT_TRUE(bag.mesh.nodes.col(back) == bag.mesh.nodes.col(front));
    EXPECT_NEAR(bag.mesh.nodes.col(back).norm(), 0.05, 4 * kEps);
  }
  EXPECT_GT(bag.mesh.nodes(2, bag.tether_anchors[0][0]), 0.049);  // the first above the outlet
}

TEST(DriverBag, bad_options_are_refused_by_name) {
  const std::pair<DriverBagOptions, const char*> bad[] = {{{.radius = 0.0}, "radius"},
                                                          {{.radius = std::nan("")}, "radius"},
                                                          {{.inflator_radius = 0.35}, "inflator_radius"},
                                                          {{.opening = 0.3}, "opening"},
                                                          {{.opening = 0.0}, "opening"},
                                                          {{.rings = 101}, "rings"},
                                                          {{.inflator_rings = 12}, "inflator_rings"},
                                                          {{.vents = 3}, "vents"},
                                                          {{.vent_ring = 2}, "vent_ring"},
                                                          {{.vent_ring = 13}, "vent_ring"}};
  for (const auto& [options, field] : bad) try {
      mesh::driver_bag(options);
      ADD_FAILURE() << "accepted: " << field;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(field), std::string::npos) << error.what();
    }
}

TEST(Refine, keeps_volume_areas_panels_and_old_nodes) {
  for (const Mesh& mesh : {mesh::icosphere(0.3, 1), mesh::passenger_bag({.depth_cells = 8,
                                                    .width_cells = 4,
                                                    .height_cells = 5,
                                                    .attachment_width_cells = 2,
                                                    .attachment_height_cells = 1,
                                                    .vent_depth_cell = 3,
                                                    .vent_height_cell = 2})
                                                        .mesh}) {
    const Mesh fine = mesh::refine(mesh);
    EXPECT_EQ(fine.element_count(), 4 * mesh.element_count());
    EXPECT_TRUE(fine.nodes.leftCols(mesh.node_count()) == mesh.nodes);
    EXPECT_TRUE(mesh::check_closed_surface(fine.nodes, fine.elements).ok());
    // Sums of that many terms, each rounded a few times.
    const double allowed = 10.0 * fine.element_count() * kEps;
    EXPECT_NEAR(
        mesh::enclosed_volume(fine.nodes, fine.elements) / mesh::enclosed_volume(mesh.nodes, mesh.elements),
        1.0, allowed);
    EXPECT_LE((mesh::panel_areas(fine) - mesh::panel_areas(mesh)).cwiseAbs().maxCoeff(),
              allowed * mesh::panel_areas(mesh).maxCoeff());
    EXPECT_EQ(fine.panel_names, mesh.panel_names);
  }
}

TEST(Refine, null_panels_get_no_node_inside) {
  const Mesh mesh = mesh::driver_bag({.rings = 8, .vent_ring = 4}).mesh;
  const std::vector<std::string> vents = {"vent_left", "vent_right"};
  Mesh fine = mesh, opened = mesh;
  opened.nodes = mesh::driver_bag({.rings = 8, .vent_ring = 4}).opened;
  for (int level = 1; level <= 2; ++level) {
    fine = mesh::refine(fine, vents);
    opened = mesh::refine(opened, vents);
    // A hexagonal rim of 6 sides, each split `level` times: a polygon of n sides in n - 2 elements.
    EXPECT_EQ(mesh::panel_elements(fine, "vent_left").size(), 6u * (1u << level) - 2u);
    EXPECT_EQ(mesh::panel_nodes(fine, "vent_left").size(), 6u * (1u << level));
    EXPECT_NEAR(area_of(fine, "vent_right"), area_of(mesh, "vent_right"), 1e-15);
    EXPECT_EQ(mesh::check_closed_surface(opened.nodes, opened.elements).describe(), "");
    EXPECT_TRUE(opened.elements == fine.elements);  // an initial shape is refined alike
  }
}

// An element whose one, two or no sides are split.
TEST(Refine, partly_split_elements_keep_their_orientation) {
  Mesh mesh = mesh::rectangle(2, 2, 1.0, 1.0, mesh::Diagonals::uniform);
  mesh.panel_names = {"sheet", "null"};
  for (int kept = 0; kept < mesh.element_count(); ++kept)
    for (int other = 0; other < mesh.element_count(); ++other) {
      mesh.panel.assign(8, 0);
      mesh.panel[static_cast<std::size_t>(kept)] = mesh.panel[static_cast<std::size_t>(other)] = 1;
      const Mesh fine = mesh::refine(mesh, std::array{std::string("null")});
      double area = 0.0;
      for (int e = 0; e < fine.element_count(); ++e) {
        const Eigen::Vector3d a = fine.nodes.col(fine.elements(0, e));
        const double z = Eigen::Vector3d(fine.nodes.col(fine.elements(1, e)) - a)
                             .cross(fine.nodes.col(fine.elements(2, e)) - a)
                             .z();
        EXPECT_GT(z, 0.0);
        area += 0.5 * z;
      }
      EXPECT_NEAR(area, 1.0, 100 * kEps);
    }
}

TEST(Refine, bad_meshes_are_refused) {
  Mesh mesh = mesh::icosphere(1.0, 0);
  EXPECT_THROW(mesh::refine(mesh, std::array{std::string("vent")}), std::invalid_argument);
  mesh.elements(0, 0) = 99;
  EXPECT_THROW(mesh::refine(mesh), std::invalid_argument);
  Mesh large = mesh::rectangle(2000, 1000, 1.0, 1.0, mesh::Diagonals::uniform);
  EXPECT_THROW(mesh::refine(large), std::invalid_argument);
}

}  // namespace
