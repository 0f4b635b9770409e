// SPDX-License-Identifier: Apache-2.0
// One query object over a sequence of steps: what it keeps from earlier ones (its scale, the last blockers
// and what opened rays) must not show in any answer. Every step is compared with brute force and with an
// object made for it alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "routes.hpp"

namespace {

using scenes::Mesh;

using routes::Carried;

void move(Mesh& mesh, scenes::Random& random, double amplitude) {
  for (auto& p : mesh.nodes) p += random.vector(amplitude);
}

TEST(motion, carried_answers_eq_fresh_ones_over_random_motions) {
  for (const bool line : {false, true}) {
    Mesh mesh = scenes::crumpled(3, 0.02, 31);
    Carried carried(mesh);
    scenes::Random random(32);
    for (int step = 0; step < 40; ++step) {
      move(mesh, random, std::pow(10.0, -12.0 + 11.0 * (step % 14) / 13.0));
      const auto source = line ? routes::line({0.02, 0.01, 0.03}, {0, 0.6, 0.8}, {1, 0, 0}, 0.15)
                               : routes::point({0.02, 0.01, 0.03}, {0, 0.6, 0.8});
      carried.step(mesh, source, routes::in_cone(mesh, source, 0.4));
    }
    EXPECT_GT(carried.hidden, carried.candidates / 20) << "the scene must hide something";
  }
}

TEST(motion, a_copy_of_a_query_shares_the_mesh_and_knows_nothing_of_the_first) {
  Mesh mesh = scenes::crumpled(3, 0.02, 31);
  const auto triangles = mesh.triangles();
  const auto count = static_cast<int>(mesh.nodes.size());
  jet::VisibilityQuery first(triangles, count);
  const auto source = routes::point({0.02, 0.01, 0.03}, {0, 0.6, 0.8});
  scenes::Random random(32);
  for (int step = 0; step < 5; ++step) {
    jet::VisibilityQuery another = first, fresh(triangles, count);
    const auto candidates = routes::in_cone(mesh, source, 0.4);
    std::vector<std::uint8_t> lit(candidates.size()), other = lit, expected = lit;
    const auto nodes = mesh.points();
    first.query(jet::VisibilityRoute::fast, nodes, source, candidates, lit, 0.001 * step);
    const auto counters = another.query(jet::VisibilityRoute::fast, nodes, source, candidates, other);
    const auto wanted = fresh.query(jet::VisibilityRoute::fast, nodes, source, candidates, expected);
    EXPECT_EQ(lit, expected);
    EXPECT_EQ(other, expected);
    EXPECT_EQ(counters.hidden, wanted.hidden);
    EXPECT_EQ(counters.fallbacks, wanted.fallbacks);
    EXPECT_EQ(counters.exact_calls, wanted.exact_calls);
    move(mesh, random, 1e-4);
  }
}

TEST(motion, carried_answers_eq_fresh_ones_when_everything_changes) {
  const Mesh first = scenes::crumpled(3, 0.03, 33);
  Carried carried(first);
  scenes::Random random(34);
  for (int step = 0; step < 24; ++step) {
    Mesh mesh = first;
    move(mesh, random, 0.1);
    const double scale = std::pow(10.0, random.integer(-6, 6));
    mesh = scenes::scaled(mesh, scale);
    const Eigen::Vector3d axis = random.vector(1.0), centre = 0.2 * scale * random.vector(1.0);
    const auto source = step % 3 == 0 ? routes::point(centre, axis)
                                      : routes::line(centre, axis, axis.unitOrthogonal(), 0.1 * scale);
    // Every fourth time all around, where there is no frame that holds the rays.
    carried.step(mesh, source,
                 step % 4 == 0 ? routes::all(mesh.elements.size()) : routes::in_cone(mesh, source, 0.5));
  }
  EXPECT_GT(carried.hidden, 100u);
}

TEST(motion, what_flies_into_the_rays_is_seen_though_far_nodes_are_not_looked_at) {
  // A closed blade crosses the beam as fast as is told; the bag breathes less.
  constexpr double stride = 0.05;
  const Eigen::Vector3d longs[] = {{0, 0, 0}, {0, 1, 0}, {0.6, 0.8, 0}};  // a point; lines
  for (const Eigen::Vector3d& along : longs) {
    Mesh mesh = scenes::star(3, 0.1, 41);
    const std::size_t bag = mesh.nodes.size();
    Mesh blade = scenes::scaled(scenes::octahedron(), 0.12);
    for (auto& p : blade.nodes) p += Eigen::Vector3d(-0.75, 0.02, 0.4);
    scenes::append(mesh, blade);
    const auto source = along.isZero() ? routes::point({0, 0, -0.2}, {0, 0, 1})
                                       : routes::line({0, 0, -0.2}, {0, 0, 1}, along, 0.1);
    Carried carried(mesh);
    scenes::Random random(42);
    std::size_t most = 0;
    for (int step = 0; step < 36; ++step) {
      const std::size_t before = carried.hidden;
      carried.step(mesh, source, routes::in_cone(mesh, source, 0.97), stride * step);
      most = std::max(most, carried.hidden - before);
      for (std::size_t i = 0; i < bag; ++i) mesh.nodes[i] += random.vector(0.01);
      for (std::size_t i = bag; i < mesh.nodes.size(); ++i) mesh.nodes[i][0] += 0.999 * stride;
    }
    EXPECT_GT(most, 3u) << "the blade must hide something";
  }
}

TEST(motion, what_an_outlet_flies_past_is_seen_though_far_nodes_are_not_looked_at) {
  // The outlet moves and turns past a blade near by, in a bag so large that its rays hardly turn.
  for (const bool line : {false, true}) {
    Mesh mesh = scenes::scaled(scenes::star(3, 0.1, 41), 20.0);
    const auto of_bag = static_cast<int>(mesh.elements.size());
    Mesh blade = scenes::scaled(scenes::octahedron(), 0.2);
    for (auto& p : blade.nodes) p += Eigen::Vector3d(0.05, 0.02, 0.4);
    scenes::append(mesh, blade);
    Carried carried(mesh);
    scenes::Random random(42);
    std::size_t most = 0, least = 1000;
    for (int step = 0; step < 48; ++step) {
      const Eigen::Vector3d centre(-0.4 + 0.02 * step, 0.0, -0.2), axis(3e-4 * step, 0.1, 1.0);
      const auto source = line ? routes::line(centre, axis, {0, 1, 0}, 0.1) : routes::point(centre, axis);
      const std::size_t before = carried.hidden;
      auto candidates = routes::in_cone(mesh, source, 0.92);
      std::erase_if(candidates, [&](int e) { return e >= of_bag; });
      carried.step(mesh, source, candidates, 1e-4 * step);
      most = std::max(most, carried.hidden - before);
      least = std::min(least, carried.hidden - before);
      for (auto& p : mesh.nodes) p += random.vector(5e-5);
    }
    EXPECT_GT(most, 3u) << "the blade must hide something";
    EXPECT_EQ(least, 0u);
  }
}

/// Nodes that a query refuses when they are no number any more, of every 37th.
std::size_t refused(double displacement_bound, double before = 1e-3) {
  const Mesh mesh = scenes::star(4, 0.1, 43);
  const auto source = routes::point({0, 0, 0}, {0, 0, 1});
  const std::vector<int> chosen = routes::in_cone(mesh, source, 0.9);
  routes::Mask lit(chosen.size());
  std::size_t count = 0;
  for (std::size_t node = 0; node < mesh.nodes.size(); node += 37) {
    Mesh poisoned = mesh;
    poisoned.nodes[node][0] = std::numeric_limits<double>::quiet_NaN();
    Carried carried(mesh);
    const auto ask = [&](const Mesh& now, double way) {
      carried.query.query(jet::VisibilityRoute::fast, now.points(), source, chosen, lit, way);
    };
    ask(mesh, 0.0);
    ask(mesh, 1e-3);
    ask(mesh, before);
    try {
      ask(poisoned, displacement_bound);
    } catch (const std::invalid_argument&) {
      ++count;
    }
  }
  return count;
}

TEST(motion, nodes_far_from_the_rays_are_looked_at_when_nothing_is_told) {
  const std::size_t all = refused(jet::kMotionUnknown);
  EXPECT_EQ(all, (scenes::star(4, 0.1, 43).nodes.size() + 36) / 37);
  EXPECT_EQ(refused(0.0), all);  // less than before: another motion
  EXPECT_EQ(refused(1.5e-3, 2e-3), all);
  EXPECT_EQ(refused(1.0), all);
  EXPECT_LT(refused(2e-3), all / 2);  // a cone of 26 degrees holds a twentieth of the sphere
}

/// Cube of half the side `half` about the origin, outward.
Mesh cube(double half) {
  Mesh mesh = scenes::welded(scenes::lattice_cube(6));
  for (auto& p : mesh.nodes) p = half / 3.0 * (p - Eigen::Vector3d(3, 3, 3));
  return mesh;
}

TEST(motion, outlet_much_longer_than_the_bag_comes_from_inside_a_shell) {
  Mesh mesh = cube(1.0);
  const std::size_t outer = mesh.elements.size();
  scenes::append(mesh, cube(0.5));
  const auto above = [](double z) { return routes::line({0, 0, z}, {0, 0, 1}, {0, 1, 0}, 100.0); };
  std::vector<int> lid;
  for (std::size_t e = 0; e < outer; ++e) {
    const Eigen::Vector3d g = mesh.centroid(e);
    if (g[2] > 0.75 && std::abs(g[0]) < 0.9 && std::abs(g[1]) < 0.4) lid.push_back(static_cast<int>(e));
  }
  scenes::Random random(44);
  std::size_t hidden = 0;
  for (int i = 0; i < 40; ++i) {
    const double low = random.uniform(-2.0, 0.0), high = random.uniform(0.0, 2.0);
    std::vector<int> part = lid;
    std::erase_if(part, [&](int e) {
      const double slope = mesh.centroid(static_cast<std::size_t>(e))[0] / 0.3;
      return slope < low || slope > high;
    });
    if (part.empty()) continue;
    Carried carried(mesh);
    carried.step(mesh, above(0.7), part, 0.0);
    carried.step(mesh, above(0.0), lid, 0.0);
    hidden += carried.hidden;
  }
  EXPECT_GT(hidden, 100u) << "the inner shell must hide something";
}

TEST(motion, every_query_says_how_far_nodes_moved) {
  // A blade that was far from the rays is put among them; the query after it may be any that can be asked.
  using Route = jet::VisibilityRoute;
  const auto source = routes::point({0, 0, -0.2}, {0, 0, 1});
  for (const double displacement_bound : {jet::kMotionUnknown, 0.0}) {
    for (const Route route : routes::kAll) {
      for (const int candidates : {-1, 0, 1}) {  // refused, none, some
        Mesh mesh = scenes::star(3, 0.1, 41), blade = scenes::scaled(scenes::octahedron(), 0.12);
        for (auto& p : blade.nodes) p += Eigen::Vector3d(-0.75, 0.02, 0.4);
        const std::size_t bag = mesh.nodes.size();
        scenes::append(mesh, blade);
        const std::vector<int> chosen = routes::in_cone(mesh, source, 0.97);
        Carried carried(mesh);
        carried.step(mesh, source, chosen, 0.0);
        carried.step(mesh, source, chosen, 1e-3);
        EXPECT_EQ(carried.hidden, 0u);
        for (std::size_t i = bag; i < mesh.nodes.size(); ++i) mesh.nodes[i][0] += 0.75;
        const std::vector<int> between(static_cast<std::size_t>(std::abs(candidates)),
                                       candidates < 0 ? -1 : chosen.front());
        routes::Mask lit(between.size());
        const auto ask = [&] {
          carried.query.query(route, mesh.points(), source, between, lit, displacement_bound);
        };
        if (candidates < 0) {
          EXPECT_THROW(ask(), std::invalid_argument);
        } else {
          ask();
        }
        carried.step(mesh, source, chosen, 2e-3);
        EXPECT_GT(carried.hidden, 3u) << "the blade must hide something";
      }
    }
  }
}

TEST(motion, nodes_near_the_rays_may_pass_below_the_range_between_two_looks) {
  Mesh mesh = scenes::star(3, 0.1, 41), blade = scenes::scaled(scenes::octahedron(), 0.12);
  const std::size_t bag = mesh.nodes.size();
  for (auto& p : blade.nodes) p += Eigen::Vector3d(0.0, 0.02, 0.4);
  scenes::append(mesh, blade);
  const auto source = routes::point({0.011, 0.013, -0.2}, {0, 0, 1});
  const std::vector<int> chosen = routes::in_cone(mesh, source, 0.97);
  jet::VisibilityQuery query(mesh.triangles(), static_cast<int>(mesh.nodes.size()));
  const auto ask = [&](const Mesh& now, double displacement_bound) {
    routes::Mask lit(chosen.size());
    query.query(jet::VisibilityRoute::fast, now.points(), source, chosen, lit, displacement_bound);
    return lit;
  };
  const routes::Mask lit = ask(mesh, 0.0);
  EXPECT_GT(std::count(lit.begin(), lit.end(), 0), 3) << "the blade must hide something";
  EXPECT_EQ(ask(mesh, 1e-3), lit);
  Mesh tiny = mesh;  // the source is not in the plane x = 0, so no sign depends on so little
  for (std::size_t i = bag; i < mesh.nodes.size(); ++i)
    if (mesh.nodes[i][0] == 0.0) tiny.nodes[i][0] = 1e-120;
  EXPECT_NE(tiny.nodes, mesh.nodes);
  EXPECT_EQ(ask(tiny, 2e-3), lit);
  EXPECT_THROW(ask(tiny, jet::kMotionUnknown), std::invalid_argument);
}

TEST(motion, candidates_in_any_order_and_named_twice) {
  const Mesh mesh = scenes::crumpled(3, 0.05, 35);
  Carried carried(mesh);
  const jet::RaySource source = routes::point({0.05, 0.02, 0.01}, {0, 1, 1});
  std::vector<int> chosen = routes::in_cone(mesh, source, 0.2);
  std::reverse(chosen.begin(), chosen.end());
  carried.step(mesh, source, chosen);
  const std::vector<int> once = chosen;
  while (chosen.size() <= mesh.elements.size()) chosen.insert(chosen.end(), once.begin(), once.end());
  carried.step(mesh, source, chosen);
  EXPECT_GT(carried.hidden, 10u);
}

}  // namespace
