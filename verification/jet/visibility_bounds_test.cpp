// SPDX-License-Identifier: Apache-2.0
// Rays that leave the bounds kept for them, from one query to the next, and bounds from the shortest lines.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numeric>
#include <vector>

#include "routes.hpp"

namespace {

using routes::Carried;
using scenes::Mesh;

TEST(motion, rays_that_leave_the_bounds_kept_for_them_meet_what_is_beyond_them) {
  for (const bool line : {false, true}) {
    const Mesh bag = scenes::star(3, 0.05, 44);
    const auto source =
        line ? routes::line({0, 0, -0.2}, {0, 0, 1}, {0, 1, 0}, 0.1) : routes::point({0, 0, -0.2}, {0, 0, 1});
    const std::vector<int> chosen = routes::in_cone(bag, source, 0.97);
    ASSERT_GT(chosen.size(), 4u);
    // Half-way to each of them a closed blade, on the ray or between it and the axis.
    const auto scene = [&](double width, double place) {
      Mesh mesh = bag;
      for (auto& p : mesh.nodes) p.x() *= width;
      for (const int e : chosen) {
        Mesh blade = scenes::scaled(scenes::octahedron(), 0.01);
        const Eigen::Vector3d target = mesh.centroid(static_cast<std::size_t>(e));
        const double y = 0.5 * (line ? std::clamp(target.y(), -0.1, 0.1) + target.y() : target.y());
        for (auto& p : blade.nodes)
          p += Eigen::Vector3d(0.5 * place * target.x(), y, 0.5 * (target.z() - 0.2));
        scenes::append(mesh, blade);
      }
      return mesh;
    };
    Mesh mesh = scene(1.0, 0.7);
    Carried carried(mesh);
    double displacement_bound = 0.0, width = 1.0;
    std::size_t hidden = 0;
    for (int step = 0; step < 12; ++step) {
      const std::size_t before = carried.hidden;
      carried.step(mesh, source, chosen, displacement_bound);
      if (step % 4 == 3) hidden += carried.hidden - before;
      width *= step % 4 == 2 ? 1.2 : 1.001;
      const Mesh next = scene(width, step % 4 == 2 ? 1.0 : 0.7);
      double farthest = 0.0;
      for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
        farthest = std::max(farthest, (next.nodes[i] - mesh.nodes[i]).norm());
      displacement_bound += 1.001 * farthest;
      mesh = next;
    }
    EXPECT_GT(hidden, 3 * chosen.size() / 2) << "most must be hidden as they leave";
  }
}

/// A line shorter than floats hold is still one: its rays are bounded by places along it, not by slopes.
TEST(fast_route, lines_shorter_than_floats_agree) {
  const Eigen::Vector3d far_off(0, 0.05, 0.5), aside(0, 0.5, 0.1), in_the_way(0, 0.05, 0.01);
  Mesh mesh;  // eight elements at each, so that they do not share patches
  for (const Eigen::Vector3d& at : {far_off, aside, in_the_way}) {
    const Eigen::Vector3d u(1, 0, 0), v = at.normalized().cross(u);
    const double size = at == in_the_way ? 3e-3 : 1e-3;
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector3d centre = (1.0 + 1e-3 * i) * at;
      const int n = static_cast<int>(mesh.nodes.size());
      mesh.nodes.push_back(centre + size * u);
      mesh.nodes.push_back(centre + size * (0.8 * v - 0.5 * u));
      mesh.nodes.push_back(centre - size * (0.8 * v + 0.5 * u));
      mesh.elements.push_back({n, n + 1, n + 2});
    }
  }
  std::vector<int> chosen(16);
  std::iota(chosen.begin(), chosen.end(), 0);
  for (const double half_long : {1e-30, 1e-40, 1e-50, 1e-99}) {
    Carried carried(mesh);
    carried.step(mesh, routes::line({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, half_long), chosen, 0.0);
    EXPECT_EQ(carried.hidden, 15u);
  }
}

TEST(motion, elements_upstream_that_are_newly_asked_about_are_aside) {
  const Mesh mesh = scenes::crumpled(3, 0.05, 45);
  const auto source = routes::point({0.05, 0.02, 0.01}, {0, 1, 1});
  std::vector<int> chosen = routes::in_cone(mesh, source, 0.5);
  Carried carried(mesh);
  for (int step = 0; step < 3; ++step) carried.step(mesh, source, chosen, 1e-6 * step);
  const auto behind = routes::in_cone(mesh, routes::point(source.centre, {0, -1, -1}), 0.5);
  for (std::size_t i = 0; i < behind.size(); i += behind.size() / 40 + 1) chosen.push_back(behind[i]);
  const std::size_t before = carried.hidden;
  carried.step(mesh, source, chosen, 3e-6);
  EXPECT_GT(carried.hidden, before + 3);
}

}  // namespace
