// SPDX-License-Identifier: Apache-2.0
// Pairs of elements that cross, against CGAL's test of whole meshes.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "crossed_meshes.hpp"
#include "mesh/icosphere.hpp"
#include "results/crossing.hpp"
#include "run_case.hpp"

namespace {

using crossed::cube;
using crossed::together;
using driver::crossing_pairs;
using Eigen::Vector3d;
using mesh::Mesh;
using Pairs = std::vector<std::pair<int, int>>;

// The second route. It also lists triangles without area, each with itself.
Pairs pairs_by_cgal(const Mesh& mesh) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
  Surface surface;
  std::vector<Surface::Vertex_index> node;
  for (const auto& x : mesh.nodes.colwise()) node.push_back(surface.add_vertex({x(0), x(1), x(2)}));
  for (const auto& e : mesh.elements.colwise())
    surface.add_face(node[static_cast<std::size_t>(e(0))], node[static_cast<std::size_t>(e(1))],
                     node[static_cast<std::size_t>(e(2))]);
  std::vector<std::pair<Surface::Face_index, Surface::Face_index>> found;
  CGAL::Polygon_mesh_processing::self_intersections(surface, std::back_inserter(found));
  Pairs pairs;
  for (const auto& [f, g] : found)
    if (f != g) pairs.emplace_back(std::minmax(static_cast<int>(f.idx()), static_cast<int>(g.idx())));
  std::ranges::sort(pairs);
  return pairs;
}

Pairs pairs_of(const Mesh& mesh) {
  return crossing_pairs(mesh.nodes, mesh.elements);
}

// Triangles of a plane fan and of anything else, each with nodes of its own unless they are shared.
Mesh triangles(const std::vector<Vector3d>& nodes, const std::vector<Eigen::Vector3i>& elements) {
  Mesh mesh;
  mesh.nodes.resize(3, static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t n = 0; n < nodes.size(); ++n) mesh.nodes.col(static_cast<Eigen::Index>(n)) = nodes[n];
  mesh.elements.resize(3, static_cast<Eigen::Index>(elements.size()));
  for (std::size_t e = 0; e < elements.size(); ++e)
    mesh.elements.col(static_cast<Eigen::Index>(e)) = elements[e];
  return mesh;
}

Mesh shaken(Mesh mesh, double amplitude, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> number;
  for (double& x : mesh.nodes.reshaped()) x += amplitude * number(random);
  return mesh;
}

TEST(crossing, triangles_that_share_nothing_cross_where_they_touch) {
  const std::vector<Eigen::Vector3i> apart{{0, 1, 2}, {3, 4, 5}};
  const auto pairs = [&](const Vector3d& tip) {
    return crossing_pairs(
               triangles({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, tip, {1, 1, 2}, {2, 1, 2}}, apart).nodes,
               triangles({}, apart).elements)
        .size();
  };
  EXPECT_EQ(pairs({1, 1, -1}), 1u) << "through the face";
  EXPECT_EQ(pairs({1, 1, 0}), 1u) << "a node on the face";
  EXPECT_EQ(pairs({1, 1, 0x1p-1000}), 0u) << "a hair above it";
  EXPECT_EQ(pairs({0, 0, 0}), 1u) << "a node on a node of another number";
  EXPECT_EQ(pairs({5, 5, 0}), 0u) << "beside it";
}

TEST(crossing, neighbours_cross_only_elsewhere_than_where_they_are_joined) {
  const auto crosses = [](const std::vector<Vector3d>& nodes, const std::vector<Eigen::Vector3i>& elements) {
    return !pairs_of(triangles(nodes, elements)).empty();
  };
  const std::vector<Eigen::Vector3i> edge{{0, 1, 2}, {1, 0, 3}}, node{{0, 1, 2}, {0, 3, 4}};
  const Vector3d a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  EXPECT_FALSE(crosses({a, b, c, {0, -1, 0}}, edge)) << "flat";
  EXPECT_FALSE(crosses({a, b, c, {0.3, 0.3, 1e-300}}, edge)) << "almost folded shut";
  EXPECT_TRUE(crosses({a, b, c, {0.3, 0.3, 0}}, edge)) << "folded shut";
  EXPECT_FALSE(crosses({a, b, c, {-1, 0, 0}, {0, -1, 0}}, node)) << "beyond the node, in one plane";
  EXPECT_TRUE(crosses({a, b, c, {0.2, 0.3, 0}, {-1, 0, 1}}, node)) << "a corner on the face";
  EXPECT_TRUE(crosses({a, b, c, {1, 1, 1}, {0.5, 0.5, -1}}, node)) << "through the opposite edge";
  EXPECT_TRUE(crosses({a, b, c}, {{0, 1, 2}, {2, 1, 0}})) << "on each other";
  EXPECT_FALSE(crosses({a, b, {2, 0, 0}, {0.2, 0, 0}, {0, 0, 1}, {0, 1, 1}}, {{0, 1, 2}, {3, 4, 5}}))
      << "one without area";
}

TEST(crossing, pairs_are_those_of_cgal) {
  std::size_t pairs = 0;
  for (const int levels : {2, 4}) {
    const Mesh sphere = mesh::icosphere(1.0, levels);
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      Mesh mesh = shaken(sphere, std::pow(0.5, levels) * (0.1 + 0.05 * static_cast<double>(seed)), seed);
      if (seed % 3 == 1) mesh.nodes.row(static_cast<Eigen::Index>(seed) % 2) *= 1e-3;  // flattened
      // On a lattice, where nodes, edges and planes meet exactly and elements have no area.
      if (seed % 3 == 2) mesh.nodes = (mesh.nodes.array() * 12.0).round().matrix() / 12.0;
      ASSERT_EQ(pairs_of(mesh), pairs_by_cgal(mesh)) << levels << " levels, seed " << seed;
      pairs += pairs_of(mesh).size();
    }
    Mesh flat = sphere;
    flat.nodes.row(2).setZero();
    EXPECT_EQ(pairs_of(flat), pairs_by_cgal(flat)) << "layers on each other";
    const Mesh two = together(sphere, sphere, {1.0, 0.0, 0.0});
    EXPECT_EQ(pairs_of(two), pairs_by_cgal(two));
  }
  const Mesh cubes = together(cube(), cube(), {0.5, 0.0, 0.0});
  EXPECT_EQ(pairs_of(cubes), pairs_by_cgal(cubes)) << "faces in common planes";
  EXPECT_GT(pairs, 1000u);
}

// The bag of the paper's scene while it unfolds.
TEST(crossing, pairs_of_a_bag_are_those_of_cgal) {
  const driver::Scene scene = coupled::scene_of("passenger_pendulum", {"scene.end_time=0.012"});
  driver::State state = driver::make_state(scene);
  double next = 0.0;
  std::size_t most = 0;
  driver::run_scene(scene, state, [&](bool, const driver::State& now) {
    if (now.time < next) return;
    next += 2e-3;
    Mesh mesh = scene.bag->mesh;
    mesh.nodes = now.bag->position.map();
    const Pairs pairs = crossing_pairs(now.bag->position.map(), mesh.elements);
    EXPECT_EQ(pairs, pairs_by_cgal(mesh)) << now.time;
    most = std::max(most, pairs.size());
  });
  EXPECT_GT(most, 100u);
}

}  // namespace
