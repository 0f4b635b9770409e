// SPDX-License-Identifier: Apache-2.0
// Holes of a surface: found again where elements were taken out, and closed.
#include "mesh/holes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "mesh/icosphere.hpp"
#include "mesh/merge.hpp"
#include "mesh/passenger_bag.hpp"
#include "mesh/surface_check.hpp"

namespace holes {
namespace {

using mesh::Mesh;

Mesh without(const Mesh& mesh, const std::function<bool(int)>& goes) {
  Mesh rest = mesh;
  rest.panel.clear();
  Eigen::Index count = 0;
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (goes(e)) continue;
    rest.elements.col(count++) = mesh.elements.col(e);
    rest.panel.push_back(mesh.panel[static_cast<std::size_t>(e)]);
  }
  rest.elements.conservativeResize(3, count);
  return mesh::used_nodes(rest);
}

Mesh without_panels(const Mesh& mesh, const std::vector<std::string>& names) {
  return without(mesh, [&](int e) {
    const auto& name = mesh.panel_names[static_cast<std::size_t>(mesh.panel[static_cast<std::size_t>(e)])];
    return std::ranges::find(names, name) != names.end();
  });
}

// What closing the first hole says; empty if it is closed.
std::string refusal(Mesh mesh, double longest = 100.0) {
  try {
    mesh::close_hole(mesh, mesh::find_holes(mesh.nodes, mesh.elements).front(), "cap", longest);
    return {};
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

// Vent and mouth of the passenger bag are plane: closed again, it has the same volume and the same areas.
TEST(holes, of_panels_taken_out_are_closed_to_the_same_bag) {
  const Mesh whole = mesh::passenger_bag().mesh;
  Mesh bag = without_panels(whole, {"attachment", "vent"});
  const auto holes = mesh::find_holes(bag.nodes, bag.elements);
  ASSERT_EQ(holes.size(), 2u);
  EXPECT_GT(holes[0].plane.length, holes[1].plane.length);
  mesh::close_hole(bag, holes[0], "mouth", 1.5);
  mesh::close_hole(bag, holes[1], "window", 1.5);
  EXPECT_TRUE(mesh::check_closed_surface(bag.nodes, bag.elements).ok());
  const double volume = mesh::enclosed_volume(whole.nodes, whole.elements);
  EXPECT_NEAR(mesh::enclosed_volume(bag.nodes, bag.elements), volume, 1e-12 * volume);
  const auto area = [](const Mesh& mesh, const char* name) {
    return mesh::panel_areas(mesh)(mesh::panel_index(mesh, name));
  };
  EXPECT_NEAR(area(bag, "mouth"), area(whole, "attachment"), 1e-15);
  EXPECT_NEAR(area(bag, "window"), area(whole, "vent"), 1e-15);
  EXPECT_EQ(mesh::panel_elements(bag, "mouth").size(), holes[0].nodes.size() - 2);
  EXPECT_TRUE(mesh::find_holes(bag.nodes, bag.elements).empty());
}

// A sphere without its cap above z: the hole is its circle, and what is left has the volume of a frustum's
// sum; both to the second order of the mesh.
TEST(holes, have_length_area_and_place) {
  const Mesh sphere = mesh::icosphere(1.0, 5);
  const Mesh open = without(sphere, [&](int e) {
    return sphere.nodes(Eigen::all, sphere.elements.col(e)).row(2).minCoeff() > 0.8;
  });
  const auto holes = mesh::find_holes(open.nodes, open.elements);
  ASSERT_EQ(holes.size(), 1u);
  const auto& plane = holes[0].plane;
  const double level = plane.centre.z(), radius = std::sqrt(1.0 - level * level);
  EXPECT_NEAR(level, 0.8, 0.04);  // an element
  EXPECT_NEAR(plane.centre.head(2).norm(), 0.0, 0.02);
  EXPECT_NEAR(plane.area, std::numbers::pi * radius * radius, 0.05);
  EXPECT_GT(plane.length, 2.0 * std::numbers::pi * radius * 0.99);  // its edges run to and fro
  EXPECT_LT(plane.off_plane, 0.04);
  EXPECT_GT(plane.normal.z(), 0.99);  // outward
  Mesh closed = open;
  mesh::close_hole(closed, holes[0], "cap", 10.0);
  EXPECT_TRUE(mesh::check_closed_surface(closed.nodes, closed.elements).ok());
}

// The sheet below has the shorter diagonal already, so the cap takes the longer one.
TEST(holes, are_closed_without_a_second_element_on_an_edge) {
  Mesh bag;
  bag.nodes = Eigen::Matrix3Xd{{0.0, 1.0, 1.1, 0.0}, {0.0, 0.0, 1.0, 1.0}, {0.0, -0.05, 0.0, -0.05}};
  bag.elements = Eigen::Matrix3Xi{{0, 1}, {3, 3}, {1, 2}};
  bag.panel = {0, 0};
  bag.panel_names = {"sheet"};
  bag.line = {7, 8};
  const auto holes = mesh::find_holes(bag.nodes, bag.elements);
  ASSERT_EQ(holes.size(), 1u);
  mesh::close_hole(bag, holes[0], "cap", 10.0);
  EXPECT_TRUE(mesh::check_closed_surface(bag.nodes, bag.elements).ok());
  EXPECT_EQ(bag.panel_names, (std::vector<std::string>{"sheet", "cap"}));
  EXPECT_EQ(bag.panel, (std::vector<int>{0, 0, 1, 1}));
  EXPECT_EQ(bag.line.size(), 4u);
}

TEST(holes, that_no_cap_fits_are_refused) {
  const Mesh sphere = mesh::icosphere(1.0, 2);
  const Mesh half = without(sphere, [&](int e) {
    return sphere.nodes(Eigen::all, sphere.elements.col(e)).row(2).maxCoeff() > 0.3;
  });
  EXPECT_EQ(refusal(half), "");
  EXPECT_NE(refusal(half, 0.5).find(" m off its plane is longer than 0.5 m, the longest to be closed"),
            std::string::npos);
  Mesh bent = half;
  for (auto x : bent.nodes.colwise()) x.z() += 0.5 * x.x() * x.x();
  EXPECT_NE(refusal(bent).find(" is not plane: a corner is "), std::string::npos) << refusal(bent);
  // A seam that is open, its two sides on each other.
  Mesh slit;
  slit.nodes = Eigen::Matrix3Xd{{0, 2, 1, 1, 1, 1}, {0, 0, 0, 0, 1, -1}, {0, 0, 0, 0, 0, 0}};
  slit.elements = Eigen::Matrix3Xi{{0, 2, 0, 5, 0, 1}, {2, 1, 5, 1, 4, 5}, {4, 4, 3, 3, 5, 4}};
  slit.panel.assign(6, 0);
  slit.panel_names = {"sheet"};
  EXPECT_NE(refusal(slit).find("the hole of 4 nodes, 4 m long"), std::string::npos);
  EXPECT_NE(refusal(slit).find("is rather a seam whose sides parted: its area is 0 times"),
            std::string::npos);
  // Its sides parted, and parted by more: 4 pi A / L^2 is 0.0488, and 0.12.
  slit.nodes(1, 2) = 0.0622;
  EXPECT_NE(refusal(slit).find("0.0622 m2 around (1, 0.0155, 0) m, 0 m off its plane is rather a seam whose "
                               "sides parted: its area is 0.0488 times that of a circle of its length, "
                               "allowed: at least 0.1; join the sides by gasjet mesh convert --merge"),
            std::string::npos)
      << refusal(slit);
  slit.nodes(1, 2) = 0.15;
  EXPECT_EQ(refusal(slit), "");
}

TEST(holes, that_meet_are_refused_at_their_node) {
  const Mesh sphere = mesh::icosphere(1.0, 2);
  // Two elements that have one node in common.
  const int node = sphere.elements(0, 0);
  int other = 1;
  const auto shared = [&](int e) {
    int count = 0;
    for (const int a : sphere.elements.col(e)) count += (sphere.elements.col(0).array() == a).any() ? 1 : 0;
    return count;
  };
  while (!(sphere.elements.col(other).array() == node).any() || shared(other) != 1) ++other;
  const Mesh open = without(sphere, [&](int e) { return e == 0 || e == other; });
  try {
    mesh::find_holes(open.nodes, open.elements);
    ADD_FAILURE();
  } catch (const std::invalid_argument& error) {
    const std::string expected = "a hole cannot be followed at node " + std::to_string(node) + ":";
    EXPECT_EQ(std::string(error.what()).substr(0, expected.size()), expected);
  }
}

}  // namespace
}  // namespace holes
