// SPDX-License-Identifier: Apache-2.0
// Questions about elements on all sides of the source, of which half the rays run upstream.
#include <gtest/gtest.h>

#include "routes.hpp"

namespace {

using scenes::Mesh;

const Eigen::Vector3d kAxes[] = {
    {1, 0, 0}, {-1, 0, 0}, {0, 0, -1}, Eigen::Vector3d(2.0, 3.0, 6.0) / 7.0, {-0.3, 0.5, -0.7}};

std::vector<jet::RaySource> sources_at(const Eigen::Vector3d& centre, double half_long) {
  std::vector<jet::RaySource> sources;
  for (const Eigen::Vector3d& axis : kAxes) {
    sources.push_back(routes::point(centre, axis));
    sources.push_back(routes::line(centre, axis, axis.unitOrthogonal(), half_long));
  }
  return sources;
}

/// The elements that a source sees all around, by all routes; the fast one builds no tree.
jet::VisibilityCounters all_around(const Mesh& mesh, const jet::RaySource& source,
                                   const jet::SurfaceRoles& roles = {}) {
  const auto counters = routes::agreed(mesh, source, roles).counters;
  EXPECT_EQ(counters.tree_builds, 0u);
  return counters;
}

TEST(both_ways, agree_in_folded_bags_without_a_tree) {
  scenes::Random random(51);
  jet::VisibilityCounters sum;
  for (const double amplitude : {0.01, 0.05})
    for (const auto& source : sources_at(random.vector(0.2), 0.1))
      sum += all_around(scenes::crumpled(3, amplitude, 3), source);
  EXPECT_GT(sum.hidden, sum.candidates / 20);
  EXPECT_LT(sum.fallbacks, sum.candidates / 2);
}

TEST(both_ways, agree_upstream_alone) {
  const Mesh mesh = scenes::crumpled(4, 0.01, 4);
  jet::VisibilityCounters sum;
  for (const auto& source : sources_at({0.1, 0.02, 0.03}, 0.1)) {
    const auto behind = routes::in_cone(mesh, routes::point(source.centre, -source.axis), 0.3);
    ASSERT_GT(behind.size(), 100u);
    const auto counters = routes::agreed_on(behind, mesh, source).counters;
    EXPECT_EQ(counters.tree_builds, 0u);
    sum += counters;
  }
  EXPECT_LT(sum.fallbacks, sum.candidates / 4);  // of the one outlet that crosses a fold
}

// Moved downstream, a source on a wall is inside the bag or outside it. Rays upstream then begin behind the
// wall: the elements in its plane are not to be left out there.
TEST(both_ways, agree_with_sources_on_a_wall_square_to_the_axis) {
  Mesh cube = scenes::welded(scenes::lattice_cube(4));
  Mesh body = scenes::scaled(cube, 0.25);
  for (auto& p : body.nodes) p += Eigen::Vector3d(2.3, 2.1, 1.9);
  scenes::flip(body);
  scenes::append(cube, body);
  std::vector<int> wall;
  for (std::size_t e = 0; e < cube.elements.size(); ++e)
    if (cube.centroid(e)[0] == cube.corner(0, 0)[0]) wall.push_back(static_cast<int>(e));
  ASSERT_GT(wall.size(), 10u);
  std::size_t lit = 0;
  for (const Eigen::Vector3d& place :
       {cube.centroid(static_cast<std::size_t>(wall[3])), cube.corner(static_cast<std::size_t>(wall[5]), 0)})
    for (const jet::SurfaceRoles& roles : {jet::SurfaceRoles{}, jet::SurfaceRoles{{}, wall}})
      for (const auto& source : sources_at(place, 0.3))
        lit += routes::agreed(cube, source, roles).counters.lit;
  EXPECT_GT(lit, 100u);
}

TEST(both_ways, one_object_agrees_while_the_bag_moves) {
  Mesh mesh = scenes::crumpled(3, 0.03, 5);
  scenes::Random random(52);
  const auto source = routes::line({0.05, 0.02, 0.01}, {0, 1, 1}, {1, 0, 0}, 0.05);
  const auto all = routes::all(mesh.elements.size());
  const auto ahead = routes::in_cone(mesh, source, 0.5);
  routes::Carried carried(mesh);
  double bound = 0.0;
  for (int step = 0; step < 12; ++step) {
    carried.step(mesh, source, step % 3 == 1 ? ahead : all, bound);
    for (auto& p : mesh.nodes) p += random.vector(1e-3);
    bound += 2e-3;  // above the root of 3 times 1e-3
  }
  EXPECT_GT(carried.hidden, carried.candidates / 20);
}

}  // namespace
