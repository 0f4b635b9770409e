// SPDX-License-Identifier: Apache-2.0
// A skin that crumples does not pass through itself, by CGAL's test of whole meshes.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <set>

#include "skin_scenes.hpp"

namespace {

using Pairs = std::vector<std::pair<int, int>>;

// Pairs of elements that cross.
Pairs crossings(const scenes::Skin& skin, const Eigen::Matrix3Xd& nodes) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
  Surface surface;
  std::vector<Surface::Vertex_index> node;
  for (const auto& x : nodes.colwise()) node.push_back(surface.add_vertex({x(0), x(1), x(2)}));
  for (const auto& e : skin.triangles.colwise())
    surface.add_face(node[static_cast<std::size_t>(e(0))], node[static_cast<std::size_t>(e(1))],
                     node[static_cast<std::size_t>(e(2))]);
  std::vector<std::pair<Surface::Face_index, Surface::Face_index>> found;
  CGAL::Polygon_mesh_processing::self_intersections(surface, std::back_inserter(found));
  Pairs pairs;
  for (const auto& [f, g] : found) pairs.emplace_back(static_cast<int>(f.idx()), static_cast<int>(g.idx()));
  return pairs;
}

// Number of pairs that are no neighbours: no common node, and no nodes that an edge joins.
int layers_that_cross(const scenes::Skin& skin, const Eigen::Matrix3Xd& nodes) {
  std::set<std::pair<int, int>> joined;
  for (const auto& e : skin.triangles.colwise())
    for (const int a : e)
      for (const int b : e) joined.emplace(a, b);
  int count = 0;
  for (const auto& [f, g] : crossings(skin, nodes)) {
    bool neighbours = false;
    for (const int a : skin.triangles.col(f))
      for (const int b : skin.triangles.col(g)) neighbours = neighbours || joined.contains({a, b});
    count += !neighbours;
  }
  return count;
}

TEST(SkinContactCrossing, layers_of_a_crumpling_sphere_never_cross) {
  int most = 0;
  for (const bool contact : {true, false}) {
    scenes::Crumple crumple(0.15);
    const auto model = scenes::skin_contact(crumple.skin, 6e-3, 1e8);
    auto state = model.make_state();
    int crossed = 0;
    for (int n = 0; n < 300; ++n) {
      Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, crumple.nodes.cols());
      if (contact) {
        const auto level = scenes::level_of(model, state, crumple.nodes);
        forces = level.forces;
        most = std::max(most, level.result.contacts);
      }
      crumple.advance(forces, 2e-5);
      if (n % 10 == 9) crossed += layers_that_cross(crumple.skin, crumple.nodes);
    }
    if (contact)
      EXPECT_EQ(crossed, 0);
    else
      EXPECT_GT(crossed, 0);  // without contact they do
  }
  EXPECT_GT(most, 20);
}

}  // namespace
