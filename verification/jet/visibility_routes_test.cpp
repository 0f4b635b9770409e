// SPDX-License-Identifier: Apache-2.0
// The routes give the same bits on every kind of surface.
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <string>

#include "routes.hpp"

namespace {

using routes::agreed;
using scenes::Mesh;

const Eigen::Vector3d kObliqueAxis = Eigen::Vector3d(2.0, 3.0, 6.0) / 7.0;
const Eigen::Vector3d kObliqueLong = Eigen::Vector3d(3.0, -6.0, 2.0) / 7.0;

void expect_agreement(const Mesh& mesh, const Eigen::Vector3d& centre, double size = 1.0) {
  agreed(mesh, routes::point(centre, kObliqueAxis));
  agreed(mesh, routes::line(centre, {0, 0, 1}, {0, 1, 0}, 0.2 * size));
  agreed(mesh, routes::line(centre, kObliqueAxis, kObliqueLong, 0.1 * size));
}

TEST(routes, agree_on_random_soups) {
  scenes::Random random(2);
  for (std::uint64_t seed = 0; seed < 10; ++seed)
    expect_agreement(scenes::soup(150, 0.3, seed), random.vector(1.0));
}

TEST(routes, agree_on_star_shaped_bags_from_any_place) {
  scenes::Random random(3);
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const Mesh mesh = scenes::star(2, 0.6, seed);
    for (int i = 0; i < 3; ++i) expect_agreement(mesh, random.vector(0.3));
    expect_agreement(mesh, random.vector(2.0));
  }
}

TEST(routes, agree_on_folded_bags) {
  scenes::Random random(4);
  for (const double amplitude : {0.01, 0.05, 0.15}) {
    const Mesh mesh = scenes::crumpled(3, amplitude, 11);
    for (int i = 0; i < 3; ++i) expect_agreement(mesh, random.vector(0.2));
  }
}

TEST(routes, agree_on_concentric_and_on_open_surfaces) {
  expect_agreement(scenes::shell_with_body(2), {0.0, 0.1, 1.3});
  Mesh nested = scenes::sphere(2, 2.0);
  scenes::append(nested, scenes::sphere(2, 1.0));  // outward, too: winding number 2 inside
  expect_agreement(nested, {0.1, 0.2, 0.3});
  expect_agreement(nested, {0.1, 0.2, 1.3});
  expect_agreement(scenes::without_top(scenes::sphere(3), 0.3), {0.1, 0.2, -0.3});
  expect_agreement(scenes::without_top(scenes::crumpled(2, 0.1, 5), 0.1), {0.1, 0.2, -0.1});
}

TEST(routes, agree_with_the_source_on_the_surface) {
  for (const Mesh& mesh : {scenes::sphere(2), scenes::star(2, 0.4, 1), scenes::crumpled(2, 0.05, 3)}) {
    for (const std::size_t e : {3u, 20u, 77u}) {
      const Eigen::Vector3d middle = 0.5 * (mesh.corner(e, 0) + mesh.corner(e, 1));
      for (const Eigen::Vector3d& place : {mesh.corner(e, 0), middle, mesh.centroid(e)}) {
        const Eigen::Vector3d inward = -place;
        agreed(mesh, routes::point(place, inward));
        agreed(mesh, routes::line(place, inward, inward.unitOrthogonal(), 0.1));
      }
    }
  }
}

TEST(routes, agree_on_lattices_where_rays_meet_edges_and_vertices) {
  for (const int n : {1, 2, 4}) {
    Mesh cube = scenes::welded(scenes::lattice_cube(n));
    Mesh body = scenes::scaled(cube, 1.0 / 3.0);
    for (auto& p : body.nodes) p += Eigen::Vector3d(2, 2, 2);
    scenes::flip(body);
    scenes::append(cube, body);
    for (const Eigen::Vector3d& centre :
         {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(0, 1, 1), Eigen::Vector3d(0, 3, 3),
          Eigen::Vector3d(2, 2, 2), Eigen::Vector3d(2, 3, 3)}) {
      agreed(cube, routes::point(centre, {1, 0, 0}));
      agreed(cube, routes::line(centre, {1, 0, 0}, {0, 0, 1}, 1.0));
      agreed(cube, routes::line(centre, {1, 0, 0}, {0, 0, 1}, 1.0), {{0, 1}, {2, 3}});
    }
  }
}

TEST(routes, agree_on_slivers) {
  Mesh mesh = scenes::sphere(2);
  for (auto& p : mesh.nodes) p[0] *= 1e-9;
  expect_agreement(mesh, {1e-10, 0.1, 0.1});
  expect_agreement(mesh, {0.0, 0.0, 0.0});
  for (auto& p : mesh.nodes) p[1] *= 1e-9;
  expect_agreement(mesh, {0.0, 0.0, 0.25});
}

TEST(routes, agree_over_scales) {
  for (const double scale : {1e-90, 1e-6, 1e-3, 1e3, 1e6, 1e90}) {
    const Mesh bag = scenes::scaled(scenes::crumpled(2, 0.1, 9), scale);
    expect_agreement(bag, Eigen::Vector3d(0.05, 0.1, 0.02) * scale, scale);
    Mesh far = scenes::crumpled(2, 0.1, 9);  // small beside its coordinates: differences lose digits
    for (auto& p : far.nodes) p = (p + Eigen::Vector3d(1e9, 2e9, 3e9)) * scale;
    expect_agreement(far, Eigen::Vector3d(1e9 + 0.05, 2e9 + 0.1, 3e9 + 0.02) * scale, scale);
  }
}

/// About the axis `across` by a right angle, with the cosine that the mathematics library gives: 6.1e-17.
Eigen::Matrix3d right_angle(int across) {
  const double c = std::cos(std::acos(0.0)), s = std::sin(std::acos(0.0));
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  const int i = (across + 1) % 3, j = (across + 2) % 3;
  turn(i, i) = turn(j, j) = c;
  turn(i, j) = -s;
  turn(j, i) = s;
  return turn;
}

TEST(routes, agree_on_an_outlet_in_the_wall_of_a_cube_turned_by_a_right_angle) {
  scenes::Random random(6);
  std::size_t lit = 0;
  for (int seed = 0; seed < 24; ++seed) {
    const Mesh cube = scenes::welded(scenes::lattice_cube(1 + seed % 5));
    const Eigen::Vector3d outlet(0.0, random.uniform(0.5, 5.5), random.uniform(0.5, 5.5));
    for (const int across : {1, 2}) {
      const Eigen::Matrix3d turn = right_angle(across);
      Mesh mesh = cube;
      for (auto& p : mesh.nodes) p = turn * (p - outlet);
      const auto source = routes::point({0, 0, 0}, turn.col(0));
      lit += routes::agreed_on(routes::in_cone(mesh, source, 0.3), mesh, source).counters.lit;
    }
  }
  EXPECT_GT(lit, 1000u);
}

TEST(routes, agree_on_a_sheet_that_an_axis_next_to_a_coordinate_leaves_just_in_front) {
  scenes::Random random(7);
  std::size_t hidden = 0, lit = 0;
  for (int i = 0; i < 200; ++i) {
    const double lean = i == 0 ? std::cos(std::acos(0.0)) : random.uniform(1e-17, 1e-16);
    Mesh mesh;  // in the outlet's plane but for its roundings
    for (const auto& [x, y] : {std::pair{-0.9, -1.0}, {-0.8, 1.0}, {1.1, 0.1}}) {
      const Eigen::Vector3d off = random.vector(0.1);
      mesh.nodes.emplace_back(x + off[0], y + off[1], -lean * (x + off[0]));
    }
    mesh.elements.assign(8, {0, 1, 2});
    Mesh bag = scenes::sphere(1);
    for (auto& p : bag.nodes) p[2] += 0.5;
    scenes::append(mesh, bag);
    const auto source = routes::point({0, 0, 0}, {lean, 0, 1});
    std::vector<int> behind = routes::in_cone(mesh, source, 0.3);
    std::erase_if(behind, [](int e) { return e < 8; });
    const auto counters = routes::agreed_on(behind, mesh, source).counters;
    hidden += counters.hidden;
    lit += counters.lit;
  }
  EXPECT_GT(hidden, 100u);
  EXPECT_GT(lit, 100u);
}

TEST(routes, mask_does_not_depend_on_the_order_of_the_candidates) {
  const Mesh mesh = scenes::crumpled(3, 0.1, 2);
  const auto reference = agreed(mesh, routes::point({0.1, 0.1, 0.05}));
  jet::VisibilityQuery query(mesh.triangles(), static_cast<int>(mesh.nodes.size()));
  std::vector<int> reversed = routes::all(mesh.elements.size());
  std::reverse(reversed.begin(), reversed.end());
  routes::Mask lit(reversed.size());
  for (const auto route : routes::kAll) {
    query.query(route, mesh.points(), routes::point({0.1, 0.1, 0.05}), reversed, lit);
    for (std::size_t k = 0; k < reversed.size(); ++k) {
      EXPECT_EQ(lit[k], reference.lit[static_cast<std::size_t>(reversed[k])]);
    }
  }
}

TEST(routes, padded_nodes_give_the_same_mask) {
  const Mesh mesh = scenes::crumpled(2, 0.1, 2);
  Eigen::Matrix4Xd padded = Eigen::Matrix4Xd::Constant(4, static_cast<Eigen::Index>(mesh.nodes.size()),
                                                       std::numeric_limits<double>::quiet_NaN());
  padded.topRows<3>() = mesh.points();
  const jet::RaySource source = routes::point({0.1, 0.1, 0.05});
  for (const auto route : routes::kAll) {
    EXPECT_EQ(jet::visible(padded.topRows<3>(), mesh.triangles(), source, route),
              jet::visible(mesh.points(), mesh.triangles(), source, route));
  }
}

TEST(winding, counts_the_shells_around_a_source) {
  const auto number = [](const Mesh& mesh, const Eigen::Vector3d& place, const Eigen::Vector3d& axis) {
    jet::VisibilityQuery query(mesh.triangles(), static_cast<int>(mesh.nodes.size()));
    return query.winding_numbers(mesh.points(), routes::point(place, axis), std::vector<int>{0})[0];
  };
  Mesh nested = scenes::sphere(2, 2.0);
  scenes::append(nested, scenes::sphere(2, 1.0));
  EXPECT_EQ(number(nested, {0.0, 0.0, 0.0}, {1, 0, 0}), 2);
  EXPECT_EQ(number(nested, {0.0, 0.0, 1.5}, {1, 0, 0}), 1);
  EXPECT_EQ(number(nested, {0.0, 0.0, 5.0}, {1, 0, 0}), 0);
  EXPECT_EQ(number(scenes::shell_with_body(2), {0.0, 0.0, 0.0}, {1, 0, 0}), 0);
  const Mesh cube = scenes::welded(scenes::lattice_cube(2));
  EXPECT_EQ(number(cube, {0, 3, 3}, {1, 0, 0}), 1) << "on the wall, moved inward";
  EXPECT_EQ(number(cube, {0, 3, 3}, {-1, 0, 0}), 0) << "on the wall, moved outward";
  EXPECT_EQ(number(cube, {0, 3, 3}, {0, 1, 0}), std::nullopt) << "on the wall, moved along it";
  EXPECT_EQ(number(scenes::without_top(scenes::sphere(2), 0.3), {0, 0, 0}, {1, 0, 0}), std::nullopt)
      << "open";
}

/// The source lies on the inner edge of an L, in the planes of the two faces that meet there. Along one of
/// them it leaves the surface for the gas: the theorem holds, and no ray needs more than the short cut.
/// (Cross-section in x and y, edge at (1, 1).)
TEST(winding, source_that_leaves_an_element_within_its_plane) {
  const Mesh l = scenes::prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}},
                               {{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {3, 4, 5}}, 2.0);
  jet::VisibilityQuery query(l.triangles(), static_cast<int>(l.nodes.size()));
  ASSERT_TRUE(query.closed());
  const auto number = [&](const Eigen::Vector3d& place, const Eigen::Vector3d& axis) {
    return query.winding_numbers(l.points(), routes::point(place, axis), std::vector<int>{0})[0];
  };
  for (const Eigen::Vector3d& axis : {Eigen::Vector3d(0, -1, 0), Eigen::Vector3d(-1, 0, 0),
                                      Eigen::Vector3d(0, -1, 1), Eigen::Vector3d(-1, -1, 0)}) {
    for (const double z : {0.5, 1.0, 1.5}) {
      EXPECT_EQ(number({1, 1, z}, axis), 1) << axis.transpose();
      const auto source = routes::point({1, 1, z}, axis);
      agreed(l, source);
      const auto downstream = routes::agreed_on(routes::in_cone(l, source, 0.0), l, source).counters;
      EXPECT_GT(downstream.lit, 4u);
      EXPECT_EQ(downstream.fallbacks, 0u) << axis.transpose() << " at " << z;
    }
  }
  EXPECT_EQ(number({1, 1, 1}, {0, 1, 0}), std::nullopt) << "moved along the face";
  EXPECT_EQ(number({1, 1, 1}, {0, 0, 1}), std::nullopt) << "moved along the edge";
  EXPECT_EQ(number({1, 1, 1}, {1, 1, 0}), 0) << "moved out";
  EXPECT_EQ(number({1, 1, 2}, {0, -1, 0}), std::nullopt) << "moved along the end";
}

}  // namespace
