// SPDX-License-Identifier: Apache-2.0
// Where the fast route's short cut does all the work, and what the counters say where it does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "routes.hpp"

namespace {

using scenes::Mesh;

TEST(fast_route, star_shaped_bag_is_lit_without_any_search) {
  const Mesh mesh = scenes::star(3, 0.3, 5);
  for (const Eigen::Vector3d& axis : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0, -1)}) {
    for (const double cosine : {0.95, 0.7}) {
      const jet::RaySource source = routes::point({0, 0, 0}, axis);
      const auto answer = routes::agreed_on(routes::in_cone(mesh, source, cosine), mesh, source);
      EXPECT_EQ(answer.counters.lit, answer.counters.candidates);
      EXPECT_EQ(answer.counters.fallbacks, 0u);
      EXPECT_LT(answer.counters.exact_calls, 10u);
    }
  }
}

TEST(fast_route, oblique_jet_in_a_folded_bag_needs_no_fallback) {
  for (const Eigen::Vector3d& direction :
       {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(-2, 1, 2), Eigen::Vector3d(-1, -1, 0)}) {
    const Eigen::Vector3d axis = direction.normalized(), along = axis.unitOrthogonal();
    const Mesh mesh = scenes::crumpled(4, 0.01, 2);
    for (const auto& source : {routes::point({0, 0, 0}, axis), routes::line({0, 0, 0}, axis, along, 0.1)}) {
      const std::vector<int> candidates = routes::in_cone(mesh, source, 0.1);
      ASSERT_GT(candidates.size(), 500u);
      const auto counters = routes::agreed_on(candidates, mesh, source).counters;
      EXPECT_EQ(counters.fallbacks, 0u);
      EXPECT_EQ(counters.tree_builds, 0u);
      EXPECT_GT(counters.hidden, 50u);
    }
  }
}

TEST(fast_route, ray_upstream_falls_back_alone) {
  const Mesh mesh = scenes::crumpled(4, 0.01, 2);
  const jet::RaySource source = routes::point({0, 0, 0}), back = routes::point({0, 0, 0}, {-1, 0, 0});
  std::vector<int> candidates = routes::in_cone(mesh, source, 0.3);
  std::size_t facing = 0;
  for (const int e : routes::in_cone(mesh, back, 0.9)) {
    if (facing == 4 || routes::agreed_on({e}, mesh, source).counters.facing_away > 0) continue;
    candidates.push_back(e);
    ++facing;
    const auto counters = routes::agreed_on(candidates, mesh, source).counters;
    EXPECT_EQ(counters.fallbacks, facing);
    EXPECT_EQ(counters.tree_builds, 0u);
  }
  EXPECT_EQ(facing, 4u);
}

TEST(fast_route, outlet_that_crosses_the_bag_has_no_common_winding_number) {
  Mesh mesh = scenes::sphere(3), second = scenes::sphere(3, 0.8);
  for (auto& p : second.nodes) p += Eigen::Vector3d(0.0, 1.2, 0.0);
  scenes::append(mesh, second);  // sources below the second sphere's skin, y = 0.4, have 1, those above 2
  const auto turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  for (const Eigen::Matrix3d& rotation : {Eigen::Matrix3d::Identity().eval(), turn.toRotationMatrix()}) {
    Mesh turned = mesh;
    for (auto& p : turned.nodes) p = rotation * p;
    const jet::RaySource source =
        routes::line(rotation.col(1) * 0.2, rotation.col(0), rotation.col(1).normalized(), 0.6);
    std::vector<int> candidates = routes::in_cone(turned, source, 0.3);
    const auto place = [&](int e) {
      return turned.centroid(static_cast<std::size_t>(e)).dot(rotation.col(1));
    };
    std::sort(candidates.begin(), candidates.end(), [&](int a, int b) { return place(a) < place(b); });
    const auto counters = routes::agreed_on(candidates, turned, source).counters;
    EXPECT_GT(counters.hidden, 10u);
    EXPECT_EQ(counters.fallbacks, counters.lit + counters.hidden);
    EXPECT_EQ(counters.tree_builds, 0u);
  }
}

TEST(fast_route, rays_all_around_need_no_tree) {
  const Mesh folded = scenes::crumpled(3, 0.02, 2), star = scenes::star(3, 0.3, 5);
  const jet::RaySource source = routes::point({0, 0, 0});
  const auto all = routes::agreed(folded, source).counters;
  EXPECT_EQ(all.tree_builds, 0u);
  EXPECT_LT(all.fallbacks, 20u);  // those square to the axis
  EXPECT_GT(all.hidden, 100u);
  const auto lit = routes::agreed(star, source).counters;
  EXPECT_EQ(lit.tree_builds, 0u);
  EXPECT_EQ(lit.fallbacks, 0u);
  const std::vector<int> one = {0};
  EXPECT_EQ(routes::ask(jet::VisibilityRoute::cgal_tree, star, source, one).counters.tree_builds, 1u);
  EXPECT_EQ(routes::ask(jet::VisibilityRoute::brute_force, star, source, one).counters.tree_builds, 0u);
}

/// The same questions at the origin and away from it, up to 1e7 extents: never a tree. At 1e9 there is one,
/// and the counter says so.
TEST(fast_route, far_from_the_origin_it_stays_fast) {
  const Mesh folded = scenes::crumpled(4, 0.01, 2);
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 1, 1).normalized(), along = axis.unitOrthogonal();
  for (const double shift : {1e5, 1e6, 2e6, 1e9}) {
    const Eigen::Vector3d place(-shift, 0.3 * shift, 0.1 * shift);
    Mesh mesh = folded;
    for (auto& p : mesh.nodes) p += place;
    for (const auto& source : {routes::point(place, axis), routes::line(place, axis, along, 0.1)}) {
      const auto counters = routes::agreed_on(routes::in_cone(mesh, source, 0.3), mesh, source).counters;
      EXPECT_GT(counters.hidden, 50u);
      EXPECT_EQ(counters.tree_builds, shift > 1e7 ? 1u : 0u) << shift;
    }
  }
}

TEST(fast_route, nodes_that_no_element_uses_count_in_nothing) {
  const Mesh mesh = scenes::crumpled(4, 0.01, 2);
  const auto source = routes::line({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.1);
  const auto candidates = routes::in_cone(mesh, source, 0.3);
  const auto without = routes::agreed_on(candidates, mesh, source);
  for (const double far : {1e6, 1e99, std::numeric_limits<double>::quiet_NaN()}) {
    Mesh more = mesh;
    more.nodes.emplace_back(far, -far, 0.0);
    const auto with = routes::agreed_on(candidates, more, source);
    EXPECT_EQ(with.lit, without.lit);
    EXPECT_EQ(with.counters.exact_calls, without.counters.exact_calls) << far;
    EXPECT_EQ(with.counters.fallbacks, without.counters.fallbacks) << far;
    EXPECT_EQ(with.counters.tree_builds, 0u) << far;
  }
}

}  // namespace
