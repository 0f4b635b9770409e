// SPDX-License-Identifier: Apache-2.0
// Many rays in folded bags that move: a million answers against brute force, and as many as
// GASJET_TREE_QUERIES says (ten million if it says nothing) against CGAL's tree.
#include <gtest/gtest.h>

#include <cstdlib>

#include "routes.hpp"

namespace {

struct Count {
  std::size_t answers = 0, hidden = 0, fallbacks = 0;
};

/// Moves a folded bag of 8 * 4^levels elements, another one each time, until `wanted` answers agree.
Count compare(jet::VisibilityRoute reference, int levels, std::size_t wanted) {
  Count count;
  for (std::uint64_t seed = 0; count.answers < wanted; ++seed) {
    scenes::Random random(seed);
    scenes::Mesh mesh = scenes::crumpled(levels, random.uniform(0.002, 0.04), seed);
    jet::VisibilityQuery query(mesh.triangles(), static_cast<int>(mesh.nodes.size()));
    const Eigen::Vector3d axis = random.vector(1.0), centre = random.vector(0.2);
    const auto source = seed % 2 == 0 ? routes::point(centre, axis)
                                      : routes::line(centre, axis.normalized(), axis.unitOrthogonal(), 0.1);
    for (int step = 0; step < 30; ++step) {
      for (auto& p : mesh.nodes) p += random.vector(0.003);
      const std::vector<int> candidates = routes::in_cone(mesh, source, 0.2);
      routes::Mask lit(candidates.size()), truth(candidates.size());
      const auto counters = query.query(jet::VisibilityRoute::fast, mesh.points(), source, candidates, lit);
      query.query(reference, mesh.points(), source, candidates, truth);
      EXPECT_EQ(lit, truth) << "bag " << seed << " step " << step;
      count.answers += lit.size();
      count.hidden += counters.hidden;
      count.fallbacks += counters.fallbacks;
    }
  }
  return count;
}

TEST(many_rays, eq_brute_force) {
  const Count count = compare(jet::VisibilityRoute::brute_force, 3, 1000000);
  EXPECT_GT(count.hidden, count.answers / 20);
  EXPECT_LT(count.fallbacks, count.answers / 2) << "the short cut must be at work";
}

TEST(many_rays, eq_cgal_tree) {
  const char* wanted = std::getenv("GASJET_TREE_QUERIES");
  const Count count =
      compare(jet::VisibilityRoute::cgal_tree, 5,
              wanted == nullptr ? 10000000 : static_cast<std::size_t>(std::strtod(wanted, nullptr)));
  RecordProperty("answers", std::to_string(count.answers));
  EXPECT_GT(count.hidden, count.answers / 20);
}

}  // namespace
