// SPDX-License-Identifier: Apache-2.0
// The order of a mesh in which neighbours follow each other, the patches of eight in it, and their nodes.
#include "visibility/mesh_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "scenes.hpp"
#include "visibility/close_set.hpp"

namespace {

using scenes::Mesh;

TEST(mesh_order, patches_of_eight_are_compact_and_hold_each_element_once) {
  for (const Mesh& mesh : {scenes::sphere(4), scenes::soup(37, 0.3, 1), scenes::lattice_cube(4)}) {
    std::vector<jet::Triangle> triangles;
    for (const auto& t : mesh.elements) triangles.push_back({t[0], t[1], t[2]});
    const jet::OrderedMesh ordered(triangles);
    std::vector<int> seen(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const auto e = static_cast<std::size_t>(ordered.elements[i]);
      ++seen[e];
      EXPECT_EQ(ordered.rank[e], static_cast<int>(i));
      const auto begin = ordered.patch_nodes.begin() + ordered.patch_begin[i / 8],
                 end = ordered.patch_nodes.begin() + ordered.patch_begin[i / 8 + 1];
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const int node = triangles[e][corner];
        EXPECT_NE(std::find(begin, end, node), end);
        EXPECT_EQ(ordered.corner_rows[i / 8 * 24 + 8 * corner + i % 8], static_cast<std::uint32_t>(4 * node));
      }
    }
    EXPECT_EQ(seen, std::vector<int>(triangles.size(), 1));
    EXPECT_EQ(ordered.patches, static_cast<int>((triangles.size() + 7) / 8));
    if (mesh.elements.size() == 2048) {
      // Eight triangles in a strip have 10 nodes, around a node 9; blocks need not begin where a patch does.
      // At random they have 24. Filled to a multiple of four, most have 12.
      EXPECT_LT(static_cast<double>(ordered.patch_nodes.size()) / ordered.patches, 13.0);
    }
  }
}

/// Kernels load four doubles a row: behind the last node of the mesh there are none.
TEST(close_set, nodes_are_each_listed_once_and_the_last_of_the_mesh_at_the_end) {
  Mesh mesh = scenes::sphere(2);
  for (int shift = 0; shift < 12; ++shift) {
    const int nodes = static_cast<int>(mesh.nodes.size());
    for (auto& t : mesh.elements)  // the last node is each time another one
      for (int& node : t) node = (node + 5) % nodes;
    std::vector<jet::Triangle> triangles;
    for (const auto& t : mesh.elements) triangles.push_back({t[0], t[1], t[2]});
    const jet::OrderedMesh ordered(triangles);
    jet::CloseSet close;
    close.reserve(ordered, mesh.nodes.size());
    close.choose({.from = 0.0, .until = 1.0}, [&](const jet::OrderedMesh&, int* patches) {
      for (int i = 0; i < ordered.patches; ++i) patches[i] = i;
      return ordered.patches;
    });
    std::vector<std::uint32_t> listed(close.rows().begin(), close.rows().end());
    ASSERT_EQ(listed.size() % 8, 0u);
    const auto last = static_cast<std::uint32_t>(4 * (nodes - 1));
    EXPECT_EQ(listed.back(), last);
    EXPECT_EQ(std::count(listed.begin(), listed.end() - 8, last), 0);
    EXPECT_TRUE(std::is_sorted(listed.begin(), listed.end()));
    listed.erase(std::unique(listed.begin(), listed.end()), listed.end());
    EXPECT_EQ(listed.size(), mesh.nodes.size());
  }
}

}  // namespace
