// SPDX-License-Identifier: Apache-2.0
// Elements wound any way are turned back.
#include "mesh/turn_outward.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>
#include <stdexcept>

#include "mesh/icosphere.hpp"
#include "mesh/passenger_bag.hpp"
#include "mesh/surface_check.hpp"

namespace turning {
namespace {

using mesh::Mesh;

int turn_some(Mesh& mesh, double share) {
  std::mt19937 random(1);
  std::bernoulli_distribution chosen(share);
  int turned = 0;
  for (auto element : mesh.elements.colwise())
    if (chosen(random)) {
      std::swap(element(1), element(2));
      ++turned;
    }
  return turned;
}

TEST(TurnOutward, bag_comes_back) {
  const Mesh bag = mesh::passenger_bag({}).mesh;
  for (const double share : {0.0, 0.01, 0.5, 1.0}) {
    Mesh mesh = bag;
    mesh.nodes.colwise() += Eigen::Vector3d(3.0, -2.0, 1.0);
    const int turned = turn_some(mesh, share);
    EXPECT_EQ(mesh::turn_outward(mesh), turned);
    EXPECT_EQ(mesh.elements, bag.elements);
  }
}

TEST(TurnOutward, bag_with_a_hole_comes_back) {
  Mesh bag = mesh::passenger_bag({}).mesh;
  bag.elements.conservativeResize(3, bag.element_count() - 8);
  Mesh mesh = bag;
  turn_some(mesh, 0.7);
  mesh::turn_outward(mesh);
  EXPECT_EQ(mesh.elements, bag.elements);
}

TEST(TurnOutward, each_of_two_bodies_is_turned_by_itself) {
  const Mesh sphere = mesh::icosphere(1.0, 2);
  Mesh both = sphere;
  both.nodes.resize(3, 2 * sphere.node_count());
  both.nodes << sphere.nodes, sphere.nodes.colwise() + Eigen::Vector3d(0.5, 0.0, 0.0);
  both.elements.resize(3, 2 * sphere.element_count());
  both.elements << sphere.elements, (sphere.elements.array() + sphere.node_count()).matrix();
  Mesh mesh = both;
  for (int e = 0; e < sphere.element_count(); ++e) std::swap(mesh.elements(1, e), mesh.elements(2, e));
  EXPECT_EQ(mesh::turn_outward(mesh), sphere.element_count());
  EXPECT_EQ(mesh.elements, both.elements);
}

// No winding is right for all of it.
TEST(TurnOutward, strip_with_one_side_stays_a_fault) {
  constexpr int kCells = 12;
  Mesh strip;
  strip.nodes.resize(3, 2 * kCells);
  strip.elements.resize(3, 2 * kCells);
  for (int i = 0; i < kCells; ++i) {
    const double turn = 2.0 * M_PI * i / kCells;
    const Eigen::Vector3d outward(std::cos(turn), std::sin(turn), 0.0);
    const Eigen::Vector3d across =
        std::cos(0.5 * turn) * Eigen::Vector3d::UnitZ() + std::sin(0.5 * turn) * outward;
    strip.nodes.col(2 * i) = outward - 0.2 * across;
    strip.nodes.col(2 * i + 1) = outward + 0.2 * across;
    const bool last = i + 1 == kCells;
    const int low = last ? 1 : 2 * i + 2, high = last ? 0 : 2 * i + 3;
    strip.elements.col(2 * i) << 2 * i, low, 2 * i + 1;
    strip.elements.col(2 * i + 1) << low, high, 2 * i + 1;
  }
  mesh::turn_outward(strip);
  EXPECT_EQ(mesh::check_closed_surface(strip.nodes, strip.elements).inconsistent_edges.size(), 1u);
}

// The sign of a volume that is rounding says nothing.
TEST(TurnOutward, flat_surfaces_stay) {
  Mesh flat = mesh::icosphere(1.0, 3);
  flat.nodes.row(2).setZero();
  for (int i = 0; i < 8; ++i) {
    Mesh mesh = flat;
    mesh.nodes = Eigen::AngleAxisd(0.7 * i, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()).toRotationMatrix() *
                 flat.nodes;
    EXPECT_EQ(mesh::turn_outward(mesh), 0);
    EXPECT_FALSE(mesh::check_closed_surface(mesh.nodes, mesh.elements).ok());
    for (auto element : mesh.elements.rightCols(7).colwise()) std::swap(element(1), element(2));
    EXPECT_EQ(mesh::turn_outward(mesh), 7);
  }
}

TEST(TurnOutward, node_out_of_range_is_refused) {
  Mesh mesh = mesh::icosphere(1.0, 1);
  mesh.elements(0, 3) = mesh.node_count();
  EXPECT_THROW(mesh::turn_outward(mesh), std::invalid_argument);
  mesh.elements.resize(3, 0);
  EXPECT_EQ(mesh::turn_outward(mesh), 0);
}

}  // namespace
}  // namespace turning
