// SPDX-License-Identifier: Apache-2.0
// Meshes that are none are refused by name, in every build.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "mesh/icosphere.hpp"
#include "mesh/merge.hpp"
#include "mesh/mesh.hpp"
#include "mesh/refine.hpp"

namespace {

void expect_refused(const std::function<void()>& action, const std::string& name) {
  try {
    action();
    ADD_FAILURE() << name << " was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
  }
}

TEST(geometry_input, node_numbers_out_of_range) {
  for (const int wrong : {-1, 12, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
    mesh::Mesh mesh = mesh::icosphere(1.0, 0);
    mesh.elements(2, 7) = wrong;
    expect_refused([&] { mesh::element_areas(mesh.nodes, mesh.elements); }, "element_areas: node number");
    expect_refused([&] { mesh::panel_areas(mesh); }, "node number");
    expect_refused([&] { mesh::enclosed_volume(mesh.nodes, mesh.elements); }, "enclosed_volume: node number");
    expect_refused([&] { mesh::element_quality(mesh.nodes, mesh.elements); }, "element_quality: node number");
    expect_refused([&] { mesh::refine(mesh); }, "node number is out of range");
    expect_refused([&] { mesh::used_nodes(mesh); }, "used_nodes: node number");
    expect_refused([&] { mesh::merge_nodes(mesh, 0.0); }, "merge_nodes: node number");
    expect_refused([&] { mesh::panel_nodes(mesh, mesh.panel_names[0]); }, "panel_nodes: node number");
    expect_refused([&] { mesh::only_panels(mesh, mesh.panel_names); }, "only_panels: node number");
  }
  const mesh::Mesh empty;
  EXPECT_EQ(mesh::enclosed_volume(empty.nodes, empty.elements), 0.0);
  EXPECT_EQ(mesh::element_areas(empty.nodes, empty.elements).size(), 0);
}

TEST(geometry_input, panels_that_are_none) {
  for (const int wrong : {-1, 1, std::numeric_limits<int>::max()}) {
    mesh::Mesh mesh = mesh::icosphere(1.0, 0);
    mesh.panel[3] = wrong;
    expect_refused([&] { mesh::panel_areas(mesh); }, "panel_areas: panel index");
    expect_refused([&] { mesh::refine(mesh); }, "refine: panel index");
  }
  for (const std::size_t size : {0u, 19u, 21u}) {
    mesh::Mesh mesh = mesh::icosphere(1.0, 0);
    mesh.panel.resize(size);
    expect_refused([&] { mesh::panel_areas(mesh); }, "panel_areas: number of panel indices");
    expect_refused([&] { mesh::refine(mesh); }, "refine: number of panel indices");
  }
}

TEST(geometry_input, rectangles_beyond_the_numbers_of_nodes) {
  using mesh::Diagonals;
  for (const int many : {5000, 50000, std::numeric_limits<int>::max()})
    expect_refused([&] { mesh::rectangle(many, many, 1.0, 1.0, Diagonals::uniform); }, "nx ny");
  expect_refused([&] { mesh::rectangle(1, std::numeric_limits<int>::max(), 1.0, 1.0, Diagonals::uniform); },
                 "nx ny");
  expect_refused([&] { mesh::rectangle(2, 2, 1.0, 1.0, static_cast<Diagonals>(7)); }, "diagonals");
  EXPECT_EQ(mesh::rectangle(2, 3, 1.0, 1.0, Diagonals::union_jack).element_count(), 12);
}

}  // namespace
