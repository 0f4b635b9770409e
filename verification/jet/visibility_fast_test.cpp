// SPDX-License-Identifier: Apache-2.0
// The fast route with the candidates of a jet: all rays in a cone, so that its frustum and its boxes are at
// work.
#include <gtest/gtest.h>

#include "routes.hpp"

namespace {

using scenes::Mesh;

struct Tally {
  std::size_t candidates = 0, hidden = 0, fallbacks = 0, tree_builds = 0;
  template <class Counts>
  void add(const Counts& counts) {
    candidates += counts.candidates;
    hidden += counts.hidden;
    fallbacks += counts.fallbacks;
    tree_builds += counts.tree_builds;
  }
};

/// Three sources at one place, cones of three widths.
Tally expect_agreement(const Mesh& mesh, const Eigen::Vector3d& centre, const Eigen::Vector3d& axis,
                       double half_long, const jet::SurfaceRoles& roles = {}) {
  Tally tally;
  const Eigen::Vector3d along = axis.unitOrthogonal(), across = axis.cross(along).normalized();
  const jet::RaySource sources[] = {routes::point(centre, axis), routes::line(centre, axis, along, half_long),
                                    routes::line(centre, axis, (along + across).normalized(), half_long)};
  for (const auto& source : sources) {
    for (const double cosine : {0.95, 0.8, 0.3}) {
      const std::vector<int> candidates = routes::in_cone(mesh, source, cosine);
      if (!candidates.empty()) tally.add(routes::agreed_on(candidates, mesh, source, roles).counters);
    }
  }
  return tally;
}

Eigen::Vector3d random_axis(scenes::Random& random) {
  const Eigen::Vector3d axes[] = {
      {1, 0, 0}, {0, -1, 0}, Eigen::Vector3d(2.0, 3.0, 6.0) / 7.0, random.vector(1.0)};
  return axes[random.integer(0, 3)];
}

TEST(fast_route, agrees_on_folded_bags) {
  scenes::Random random(21);
  Tally tally;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const Mesh mesh = scenes::crumpled(3, 0.02 + 0.01 * static_cast<double>(seed % 4), seed);
    const Eigen::Vector3d centre = random.vector(0.25);
    tally.add(expect_agreement(mesh, centre, random_axis(random), 0.15));
  }
  EXPECT_GT(tally.candidates, 5000u);
  EXPECT_GT(tally.hidden, tally.candidates / 20) << "the scenes must hide something";
}

TEST(fast_route, agrees_on_star_shaped_and_hollow_bags) {
  scenes::Random random(22);
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Eigen::Vector3d centre = random.vector(0.4), axis = random_axis(random);
    expect_agreement(scenes::star(2, 0.6, seed), centre, axis, 0.1);
    expect_agreement(scenes::shell_with_body(2), 0.5 * centre + Eigen::Vector3d(0, 0.1, 1.3), axis, 0.1);
  }
}

TEST(fast_route, agrees_where_its_short_cut_does_not_apply) {
  scenes::Random random(23);
  Tally tally;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Mesh nested = scenes::sphere(2, 2.0);
    scenes::append(nested, scenes::star(2, 0.5, seed));  // winding number 2 inside
    Mesh inside_out = scenes::crumpled(2, 0.05, seed);
    scenes::flip(inside_out);
    for (const Mesh& mesh : {nested, inside_out, scenes::soup(200, 0.3, seed),
                             scenes::without_top(scenes::crumpled(2, 0.05, seed), 0.1)}) {
      const Eigen::Vector3d centre = random.vector(0.3);
      tally.add(expect_agreement(mesh, centre, random_axis(random), 0.2));
    }
    const Eigen::Vector3d outside = random.vector(3.0);
    expect_agreement(scenes::star(2, 0.5, seed), outside, random_axis(random), 0.3);
  }
  EXPECT_GT(tally.fallbacks, tally.candidates / 2);
}

/// A bag on a flat plate x = 0, its outlet in the plane of the plate's elements.
Mesh bag_on_plate(int levels, double fold, std::uint64_t seed) {
  Mesh mesh = scenes::sphere(levels);
  scenes::Random random(seed);
  for (auto& p : mesh.nodes) {
    p[0] = p[0] < -0.3 ? 0.0 : p[0] + 0.3;
    if (p[0] > 0.0) {
      p[0] *= 1.0 - 0.9 * fold;
      p += fold * (random.vector(0.05) + Eigen::Vector3d(0.1 + 0.1 * std::sin(15.0 * p[1]), 0.0, 0.0));
      p[0] = std::max(p[0], 1e-3);
    }
  }
  return mesh;
}

std::vector<int> plate_elements(const Mesh& mesh) {
  std::vector<int> elements;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (mesh.corner(e, 0)[0] == 0.0 && mesh.corner(e, 1)[0] == 0.0 && mesh.corner(e, 2)[0] == 0.0) {
      elements.push_back(static_cast<int>(e));
    }
  }
  return elements;
}

TEST(fast_route, outlet_in_the_plane_of_its_attachment_needs_no_fallback) {
  for (const double fold : {0.0, 0.6, 1.0}) {
    const Mesh mesh = bag_on_plate(4, fold, 3);
    const std::vector<int> plate = plate_elements(mesh);
    ASSERT_GT(plate.size(), 50u);
    const jet::SurfaceRoles roles{{}, plate};
    for (const auto& source :
         {routes::line({0, 0.013, 0.007}, {1, 0, 0}, {0, 1, 0}, 0.2),
          routes::line({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 0.2), routes::point({0, 0, 0}, {1, 0, 0})}) {
      const std::vector<int> candidates = routes::in_cone(mesh, source, 0.3);
      ASSERT_GT(candidates.size(), 100u);
      const auto answer = routes::agreed_on(candidates, mesh, source, roles);
      EXPECT_EQ(answer.counters.fallbacks, 0u) << "fold " << fold;
      if (fold == 0.0) {
        EXPECT_EQ(answer.counters.lit, candidates.size());
      }
      if (fold == 1.0) {
        EXPECT_GT(answer.counters.hidden, 0u);
      }
    }
  }
}

TEST(fast_route, agrees_on_jets_along_a_plate_that_the_folded_bag_crosses) {
  Tally tally;
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    Mesh mesh = bag_on_plate(3, 1.0, seed);
    scenes::Random random(seed);
    for (auto& p : mesh.nodes) {
      if (p[0] > 0.0) p += random.vector(0.05) - Eigen::Vector3d(0.08, 0, 0);
    }
    const std::vector<int> plate = plate_elements(mesh);
    for (const double rise : {0.01, 0.3, 2.0}) {
      const Eigen::Vector3d axis(rise, random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
      const Tally grazing = expect_agreement(mesh, {0, 0.013, 0.007}, axis, 0.2, {{}, plate});
      EXPECT_EQ(grazing.tree_builds, 0u);
      tally.add(grazing);
    }
  }
  EXPECT_GT(tally.hidden, tally.candidates / 5);
}

TEST(fast_route, agrees_with_the_outlet_an_ulp_off_its_attachment) {
  for (const double offset : {-0x1p-53, 0x1p-53, -0x1p-30, 0x1p-30}) {
    const Mesh mesh = bag_on_plate(3, 1.0, 4);
    const std::vector<int> plate = plate_elements(mesh);
    for (const jet::SurfaceRoles& roles : {jet::SurfaceRoles{{}, plate}, jet::SurfaceRoles{}}) {
      expect_agreement(mesh, {offset, 0.01, 0.02}, {1, 0, 0}, 0.2, roles);
      expect_agreement(mesh, {offset, 0.01, 0.02}, Eigen::Vector3d(6.0, 3.0, 2.0) / 7.0, 0.2, roles);
    }
  }
}

TEST(fast_route, agrees_on_rotated_plates) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  for (const double fold : {0.0, 1.0}) {
    Mesh mesh = bag_on_plate(3, fold, 5);
    const std::vector<int> plate = plate_elements(mesh);
    for (auto& p : mesh.nodes) p = turn * p;
    const Eigen::Vector3d axis = turn.col(0), centre = turn * Eigen::Vector3d(0.0, 0.01, 0.02);
    for (const jet::SurfaceRoles& roles : {jet::SurfaceRoles{{}, plate}, jet::SurfaceRoles{plate, {}}}) {
      expect_agreement(mesh, centre, axis, 0.2, roles);
      const std::size_t e = static_cast<std::size_t>(plate[5]);
      expect_agreement(mesh, mesh.corner(e, 0), axis, 0.2, roles);
      expect_agreement(mesh, mesh.corner(e, 0), (mesh.corner(e, 1) - mesh.corner(e, 0)).normalized(), 0.2,
                       roles);
    }
  }
}

TEST(fast_route, agrees_over_scales_and_far_from_the_origin) {
  Tally tally;
  for (const double scale : {1e-90, 1e-6, 1e6, 1e90}) {
    const Mesh mesh = scenes::scaled(scenes::crumpled(3, 0.02, 6), scale);
    tally.add(expect_agreement(mesh, Eigen::Vector3d(0.05, 0.1, 0.02) * scale, {0, 1, 0}, 0.1 * scale));
  }
  for (const double shift : {1e3, 1e6, 1e12}) {
    Mesh mesh = scenes::crumpled(3, 0.02, 6);
    for (auto& p : mesh.nodes) p += Eigen::Vector3d(shift, -2.0 * shift, 3.0 * shift);
    const Eigen::Vector3d centre = Eigen::Vector3d(0.05 + shift, 0.1 - 2.0 * shift, 0.02 + 3.0 * shift);
    tally.add(expect_agreement(mesh, centre, {0, 1, 0}, 0.1));
  }
  EXPECT_GT(tally.hidden, 100u);
}

TEST(fast_route, agrees_on_lattices) {
  for (const int n : {1, 2, 3}) {
    Mesh cube = scenes::welded(scenes::lattice_cube(n));
    Mesh body = scenes::scaled(cube, 1.0 / 3.0);
    for (auto& p : body.nodes) p += Eigen::Vector3d(2, 2, 2);
    scenes::flip(body);
    scenes::append(cube, body);
    for (const Eigen::Vector3d& centre :
         {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(0, 1, 1), Eigen::Vector3d(0, 3, 3),
          Eigen::Vector3d(0, 2, 2), Eigen::Vector3d(1, 3, 3)}) {
      expect_agreement(cube, centre, {1, 0, 0}, 1.0);
      expect_agreement(cube, centre, {1, 0, 0}, 1.0, {{0, 1, 5}, {2, 3, 8}});
    }
  }
}

}  // namespace
