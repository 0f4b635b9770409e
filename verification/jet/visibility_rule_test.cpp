// SPDX-License-Identifier: Apache-2.0
// The definition (J.7) against rational arithmetic and against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "claim.hpp"
#include "closed_form/occlusion.hpp"
#include "oracle.hpp"
#include "routes.hpp"

namespace {

using routes::agreed;
using scenes::Mesh;

void expect_oracle(const Mesh& mesh, const jet::RaySource& source, const std::vector<int>& transparent = {}) {
  jet::SurfaceRoles roles;
  for (const int e : transparent) (e % 2 == 0 ? roles.null_elements : roles.attachment_elements).push_back(e);
  EXPECT_EQ(agreed(mesh, source, roles).lit, oracle::lit(mesh, source, transparent));
}

TEST(visibility_rule, eq_rational_oracle_on_degenerate_lattices) {
  scenes::Random random(1);
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Mesh mesh = scenes::lattice_soup(40, 4, seed);
    const Eigen::Vector3d centre(3.0 * random.integer(0, 4), 3.0 * random.integer(0, 4),
                                 3.0 * random.integer(0, 4));
    const Eigen::Vector3d axis(random.integer(-1, 1), random.integer(-1, 1), 1.0);
    expect_oracle(mesh, routes::point(centre, axis));
    expect_oracle(mesh, routes::line(centre, axis, {0.0, 1.0, 0.0}, 3.0), {1, 2, 3, 4});
  }
}

TEST(visibility_rule, eq_rational_oracle_with_the_source_on_face_edge_and_vertex) {
  const Mesh cube = scenes::welded(scenes::lattice_cube(2));
  const Eigen::Vector3d places[] = {{0, 1, 2}, {0, 1.5, 1.5}, {0, 3, 2}, {0, 3, 3},
                                    {0, 0, 2}, {0, 0, 0},     {3, 3, 3}, {-1, 3, 3}};
  const Eigen::Vector3d axes[] = {{1, 0, 0}, {-1, 0, 0}, {1, 1, 1}, {0, 1, 0}, {1, 2, 3}};
  for (const auto& place : places) {
    for (const auto& axis : axes) {
      expect_oracle(cube, routes::point(place, axis));
    }
    expect_oracle(cube, routes::line(place, {1, 0, 0}, {0.0, 0.0, 1.0}, 2.0));
    expect_oracle(cube, routes::line(place, {1, 2, 3}, {0.0, 0.0, 1.0}, 2.0));
  }
}

TEST(visibility_rule, eq_rational_oracle_on_slivers_and_soups) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    Mesh mesh = scenes::soup(40, 0.6, seed);
    for (std::size_t e = 0; e < 20; ++e) {  // thin: one node an ulp or so beside the opposite edge
      const double t = 0.1 + 0.04 * static_cast<double>(e);
      mesh.nodes[3 * e + 2] = (1.0 - t) * mesh.nodes[3 * e] + t * mesh.nodes[3 * e + 1];
    }
    expect_oracle(mesh, routes::point({0.01, 0.02, -0.03}, {0, 0, 1}));
    expect_oracle(mesh, routes::line({0.01, 0.02, -0.03}, {0, 0, 1}, {0.6, 0.8, 0.0}, 0.5), {2, 5});
  }
}

/// A small triangle whose double centroid is exactly the origin, facing `source`: its rays run along the line
/// through both. (A given point far from the origin need not be the rounded centroid of any triangle.)
Mesh target_at_origin(const Eigen::Vector3d& source) {
  Mesh mesh;
  mesh.nodes = {{0x1p-10, 0x1p-12, 0x1p-13}, {-0x1p-12, 0x1p-10, 0x1p-12}, {}};
  mesh.nodes[2] = -(mesh.nodes[0] + mesh.nodes[1]);
  mesh.elements = {{0, 1, 2}};
  if (mesh.nodes[0].cross(mesh.nodes[1]).dot(source) > 0.0) scenes::flip(mesh);
  return mesh;
}

/// Moeller and Trumbore's test in double, closed and without tolerance: parameter of the hit or 0.
double moeller_trumbore(const Eigen::Vector3d& d, const Mesh& mesh, std::size_t e) {
  const Eigen::Vector3d ab = mesh.corner(e, 1) - mesh.corner(e, 0),
                        ac = mesh.corner(e, 2) - mesh.corner(e, 0);
  const Eigen::Vector3d h = d.cross(ac);
  const double det = ab.dot(h);
  if (det == 0.0) return 0.0;
  const Eigen::Vector3d s = -mesh.corner(e, 0), q = s.cross(ab);
  const double u = s.dot(h) / det, v = d.dot(q) / det;
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 ? ac.dot(q) / det : 0.0;
}

// Along the edge some rays miss both elements by rounding, whatever the order of the plain test's sums.
TEST(visibility_rule, ray_through_a_common_edge_does_not_leak) {
  Mesh quad;
  quad.nodes = {{0.8, 0.9, 1.1}, {0.8, -0.6, 1.3}, {-0.7, -0.5, 1.5}, {-0.6, 0.9, 1.3}};
  quad.elements = {{0, 1, 2}, {0, 2, 3}};
  int leaks = 0;
  for (int i = 1; i < 100; ++i) {
    const double t = 0.01 * i;
    const Eigen::Vector3d d = (1.0 - t) * quad.nodes[0] + t * quad.nodes[2];
    if (moeller_trumbore(d, quad, 0) == 0.0 && moeller_trumbore(d, quad, 1) == 0.0) ++leaks;
    Mesh mesh = target_at_origin(d);
    EXPECT_EQ(agreed(mesh, routes::point(4.0 * d)).lit[0], 1);
    scenes::append(mesh, quad);
    const int lit = agreed(mesh, routes::point(4.0 * d)).lit[0];
    EXPECT_EQ(lit, oracle::lit(mesh, routes::point(4.0 * d))[0]) << "at " << t;
    EXPECT_EQ(lit, 0) << "at " << t;
  }
  EXPECT_GE(leaks, 1) << "the edge was chosen because the plain test leaks here";
}

TEST(visibility_rule, element_seen_edge_on_is_decided_exactly) {
  const Eigen::Vector3d d(-0.05, 0.125, -0.45);
  Mesh mesh = target_at_origin(d);
  Mesh edge_on;
  edge_on.nodes = {{-0.2, 0.6, -0.5}, {0.2, -0.7, -0.8}, {0.0, -0.09999999999999998, -1.3}};
  edge_on.elements = {{0, 1, 2}};
  EXPECT_GT(moeller_trumbore(d, edge_on, 0), 0.3)
      << "the case was chosen because the plain test reports a hit";
  scenes::append(mesh, edge_on);
  EXPECT_EQ(agreed(mesh, routes::point(4.0 * d)).lit[0], 1) << "the ray lies in the element's plane";
  EXPECT_EQ(oracle::lit(mesh, routes::point(4.0 * d))[0], 1);
}

TEST(visibility_rule, element_never_hides_its_own_centroid) {
  Mesh mesh;
  mesh.nodes = {{-0.2, 0.0, 1.5}, {0.8, 0.6, 1.9}, {0.2, -0.1, 1.3}};
  mesh.elements = {{0, 1, 2}, {0, 2, 1}};
  const double t = moeller_trumbore(oracle::centroid(mesh, 0), mesh, 0);
  EXPECT_LT(t, 1.0) << "rounding puts the centroid behind the element";
  EXPECT_GT(t, 0.999);
  scenes::append(mesh, scenes::soup(60, 0.5, 8));  // half of their centroids lie behind, too
  for (const auto& element : mesh.elements) {
    Mesh alone = mesh;
    alone.elements = {element};
    EXPECT_EQ(agreed(alone, routes::point({0, 0, 0})).lit, oracle::lit(alone, routes::point({0, 0, 0})));
  }
}

TEST(visibility_rule, coincident_duplicate_blocks_as_rounding_says) {
  Mesh mesh = scenes::soup(20, 0.4, 5);
  const Mesh twin = mesh;
  scenes::append(mesh, twin);
  expect_oracle(mesh, routes::point({0.1, 0.2, 0.3}));
}

/// The target triangle of the closed forms cut into n^2 equal ones.
Mesh subdivided(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, int n) {
  Mesh mesh;
  const auto node = [&](int i, int j) {
    mesh.nodes.push_back(a + (b - a) * i / n + (c - a) * j / n);
    return static_cast<int>(mesh.nodes.size()) - 1;
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; i + j < n; ++j) {
      mesh.elements.push_back({node(i, j), node(i + 1, j), node(i, j + 1)});
      if (i + j < n - 1) mesh.elements.push_back({node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)});
    }
  }
  return mesh;
}

TEST(visibility_rule, hidden_fraction_eq_clipped_shadow) {
  const closed_form::Triangle2 target = {{{0, 0}, {2, 0}, {0, 2}}};
  const closed_form::Triangle2 occluders[] = {{{{0, 0}, {0.5, 0}, {0, 0.5}}},
                                              {{{0.25, 0.25}, {1, 0.25}, {0.25, 1}}}};
  const int n = 24;  // the shadows' edges run along the subdivision's lines: the fraction is exact
  for (const auto& occluder : occluders) {
    Mesh mesh = subdivided({0, 0, 2}, {2, 0, 2}, {0, 2, 2}, n);
    Mesh screen;
    for (const auto& p : occluder) screen.nodes.emplace_back(p[0], p[1], 1.0);
    screen.elements = {{0, 1, 2}};
    scenes::append(mesh, screen);
    const auto answer = agreed(mesh, routes::point({0, 0, 0}, {0, 0, 1}));
    const double hidden = static_cast<double>(answer.counters.hidden) / (n * n);
    claim::expect_near({"J.7", "clipped shadow of a triangle on 576 elements: hidden share [-]",
                        "the shadow's edges run along the elements': 4 eps"},
                       hidden, closed_form::hidden_triangle_fraction(occluder, 1.0, target, 2.0), 1e-15);
    EXPECT_DOUBLE_EQ(hidden, 0.25);
  }
}

TEST(visibility_rule, every_face_of_a_convex_bag_is_lit_from_inside) {
  const Mesh mesh = scenes::sphere(3);
  scenes::Random random(7);
  for (int i = 0; i < 10; ++i) {
    const Eigen::Vector3d inside = random.vector(0.5);
    EXPECT_EQ(agreed(mesh, routes::point(inside)).counters.lit, mesh.elements.size());
    EXPECT_EQ(agreed(mesh, routes::line(inside, {1, 0, 0}, {0, 0, 1}, 0.05)).counters.lit,
              mesh.elements.size());
  }
}

TEST(visibility_rule, every_face_of_a_star_is_lit_from_its_centre) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const Mesh mesh = scenes::star(3, 0.5, seed);
    EXPECT_EQ(agreed(mesh, routes::point({0, 0, 0})).counters.lit, mesh.elements.size());
  }
}

TEST(visibility_rule, shadow_of_a_sphere_eq_closed_cap) {
  const Mesh mesh = scenes::shell_with_body(4);
  const double distance = 1.3;
  const double cap = closed_form::sphere_shadow_half_angle(0.7, distance, 2.0);
  const auto answer = agreed(mesh, routes::point({0, 0, distance}, {0, 0, -1}));
  // The body is a polyhedron with edges up to 0.1 radii: it lies within 0.2 % of its sphere, seen under a
  // grazing angle.
  const double margin = 0.08;
  std::size_t near_edge = 0;
  for (std::size_t e = 0; e < mesh.elements.size() / 2; ++e) {
    const double angle = std::acos(-mesh.centroid(e).normalized()[2]);  // from the axis behind the body
    near_edge += std::abs(angle - cap) <= margin;
    if (std::abs(angle - cap) > margin) {
      EXPECT_EQ(answer.lit[e], angle > cap) << angle;
    }
  }
  EXPECT_LT(near_edge, mesh.elements.size() / 20);
}

}  // namespace
