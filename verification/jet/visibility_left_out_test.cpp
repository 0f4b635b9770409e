// SPDX-License-Identifier: Apache-2.0
// Elements left out of a query, against a query on the mesh without them, by every route.
#include <gtest/gtest.h>

#include "routes.hpp"

namespace {

/// The mesh without some elements, and what the others are called in it; -1 for those left out.
struct Rest {
  scenes::Mesh mesh;
  std::vector<int> number;
  Rest(const scenes::Mesh& whole, const std::vector<int>& left_out) : number(whole.elements.size(), 0) {
    mesh.nodes = whole.nodes;
    for (const int e : left_out) number[static_cast<std::size_t>(e)] = -1;
    for (std::size_t e = 0; e < number.size(); ++e) {
      if (number[e] < 0) continue;
      number[e] = static_cast<int>(mesh.elements.size());
      mesh.elements.push_back(whole.elements[e]);
    }
  }
};

/// Asks both; returns how many rays are hidden.
std::size_t expect_equal(jet::VisibilityQuery& query, const scenes::Mesh& mesh, const jet::RaySource& source,
                         const std::vector<int>& left_out) {
  const Rest rest(mesh, left_out);
  std::vector<int> asked, same;
  for (const int e : routes::in_cone(mesh, source, 0.2)) {
    const int number = rest.number[static_cast<std::size_t>(e)];
    if (number >= 0) asked.push_back(e), same.push_back(number);
  }
  query.leave_out(left_out);
  EXPECT_EQ(query.closed(), left_out.empty());
  std::size_t hidden = 0;
  for (const auto route : routes::kAll) {
    routes::Mask lit(asked.size());
    const auto counters = query.query(route, mesh.points(), source, asked, lit, 1e-3);
    const auto expected = routes::ask(route, rest.mesh, source, same);
    EXPECT_EQ(lit, expected.lit);
    EXPECT_EQ(counters.hidden, expected.counters.hidden);
    hidden = counters.hidden;
  }
  return hidden;
}

TEST(left_out, masks_eq_those_of_the_mesh_without) {
  const scenes::Mesh mesh = scenes::crumpled(3, 0.02, 51);
  jet::VisibilityQuery query(mesh.triangles(), static_cast<int>(mesh.nodes.size()));
  scenes::Random random(52);
  std::size_t most = 0, least = mesh.elements.size();
  for (const bool line : {false, true}) {
    const auto source = line ? routes::line({0.02, 0.01, 0.03}, {0, 0.6, 0.8}, {1, 0, 0}, 0.15)
                             : routes::point({0.02, 0.01, 0.03}, {0, 0.6, 0.8});
    for (int step = 0; step < 12; ++step) {
      std::vector<int> left_out;
      for (const int e : routes::all(mesh.elements.size()))
        if (random.integer(0, 11) < step) left_out.push_back(e);
      const std::size_t hidden = expect_equal(query, mesh, source, left_out);
      most = std::max(most, hidden), least = std::min(least, hidden);
    }
  }
  EXPECT_GT(most, least + 50) << "what is left out must have hidden something";
}

TEST(left_out, a_source_on_what_is_left_out_does_not_move) {
  const scenes::Mesh mesh = scenes::split(scenes::octahedron());
  jet::VisibilityQuery query(mesh.triangles(), static_cast<int>(mesh.nodes.size()));
  for (std::size_t e = 0; e < mesh.elements.size(); e += 5) {
    const auto source = routes::point(mesh.corner(e, 0), -mesh.corner(e, 0));
    std::vector<int> touched;
    for (std::size_t f = 0; f < mesh.elements.size(); ++f)
      for (int k = 0; k < 3; ++k)
        if (mesh.corner(f, k) == mesh.corner(e, 0)) touched.push_back(static_cast<int>(f));
    expect_equal(query, mesh, source, touched);
    expect_equal(query, mesh, source, {static_cast<int>(e)});
    expect_equal(query, mesh, source, {});
  }
}

TEST(left_out, an_element_that_is_none_is_refused) {
  const scenes::Mesh mesh = scenes::octahedron();
  jet::VisibilityQuery query(mesh.triangles(), static_cast<int>(mesh.nodes.size()));
  for (const int wrong : {-1, 8})
    EXPECT_THROW(query.leave_out(std::vector<int>{wrong}), std::invalid_argument);
  EXPECT_TRUE(query.closed());
}

}  // namespace
