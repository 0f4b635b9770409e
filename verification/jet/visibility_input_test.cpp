// SPDX-License-Identifier: Apache-2.0
// Input that the visibility refuses, and what it says.
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <limits>
#include <string>

#include "routes.hpp"

namespace {

using scenes::Mesh;

TEST(input, wrong_meshes_sources_and_sizes_are_refused) {
  const Mesh mesh = scenes::sphere(1);
  const int nodes = static_cast<int>(mesh.nodes.size());
  EXPECT_THROW(jet::VisibilityQuery(Eigen::Matrix3Xi(3, 0), nodes), std::invalid_argument);
  EXPECT_THROW(jet::VisibilityQuery(mesh.triangles(), nodes - 1), std::invalid_argument);
  EXPECT_THROW(jet::VisibilityQuery(mesh.triangles(), nodes, {{32}, {}}), std::invalid_argument);
  EXPECT_THROW(jet::VisibilityQuery(mesh.triangles(), nodes, {{}, {-1}}), std::invalid_argument);
  jet::VisibilityQuery query(mesh.triangles(), nodes);
  routes::Mask lit(1);
  const std::vector<int> one = {0}, wrong = {32};
  const jet::RaySource source = routes::point({0, 0, 0});
  for (const auto route : routes::kAll) {
    EXPECT_THROW(query.query(route, mesh.points(), source, wrong, lit), std::invalid_argument);
    EXPECT_THROW(query.query(route, mesh.points(), source, one, {}), std::invalid_argument);
    EXPECT_THROW(query.query(route, mesh.points().leftCols(3), source, one, lit), std::invalid_argument);
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e-101, 1e101}) {
      Eigen::Matrix3Xd points = mesh.points();
      points(2, 7) = bad;
      EXPECT_THROW(query.query(route, points, source, one, lit), std::invalid_argument);
      EXPECT_THROW(query.query(route, mesh.points(), routes::point({0, bad, 0}), one, lit),
                   std::invalid_argument);
      EXPECT_THROW(
          query.query(route, mesh.points(), routes::line({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, bad), one, lit),
          std::invalid_argument);
    }
    EXPECT_THROW(query.query(route, mesh.points(), routes::point({0, 0, 0}, {0, 0, 0}), one, lit),
                 std::invalid_argument);
  }
}

TEST(input, every_refusal_names_what_is_wrong) {
  const Mesh mesh = scenes::sphere(1);
  const int nodes = static_cast<int>(mesh.nodes.size());
  const Eigen::Matrix3Xi triangles = mesh.triangles();
  jet::VisibilityQuery query(triangles, nodes);
  Eigen::Matrix3Xd spoilt = mesh.points();
  spoilt(1, 5) = std::numeric_limits<double>::quiet_NaN();
  routes::Mask lit(1);
  const auto ask = [&](const Eigen::Matrix3Xd& points, const jet::RaySource& source, int candidate) {
    query.query(jet::VisibilityRoute::fast, points, source, std::vector<int>{candidate}, lit);
  };
  const auto line = [](const Eigen::Vector3d& along) {
    return routes::line({0, 0, 0}, {1, 0, 0}, along, 0.1);
  };
  const struct {
    const char* named;
    std::function<void()> call;
  } cases[] = {{"mesh has no element", [&] { jet::VisibilityQuery(Eigen::Matrix3Xi(3, 0), nodes); }},
               {"node index 17, allowed: 0 to 16", [&] { jet::VisibilityQuery(triangles, 17); }},
               {"null element 32, allowed: 0 to 31",
                [&] {
                  jet::VisibilityQuery(triangles, nodes, {{32}, {}});
                }},
               {"attachment element -1",
                [&] {
                  jet::VisibilityQuery(triangles, nodes, {{}, {-1}});
                }},
               {"candidate 32",
                [&] {
                  ask(mesh.points(), routes::point({0, 0, 0}), 32);
                }},
               {"node 5 has coordinate nan",
                [&] {
                  ask(spoilt, routes::point({0, 0, 0}), 0);
                }},
               {"source axis is zero",
                [&] {
                  ask(mesh.points(), routes::point({0, 0, 0}, {0, 0, 0}), 0);
                }},
               {"source long_direction is zero", [&] {
                  ask(mesh.points(), line({0, 0, 0}), 0);
                }}};
  for (const auto& [named, call] : cases) {
    try {
      call();
      ADD_FAILURE() << named << " was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
    }
  }
}

TEST(input, refused_coordinates_are_shown_with_all_their_digits) {
  const Mesh mesh = scenes::sphere(1);
  jet::VisibilityQuery query(mesh.triangles(), static_cast<int>(mesh.nodes.size()));
  routes::Mask lit(1);
  const std::vector<int> one = {0};
  for (const double bad : {1.0 / 3.0 * 1e-120, -4.0 / 3.0 * 1e101}) {
    for (const bool half_long : {false, true}) {
      auto source = routes::line({bad, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1.0);
      if (half_long) source = routes::line({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, bad);
      try {
        query.query(jet::VisibilityRoute::fast, mesh.points(), source, one, lit);
        ADD_FAILURE() << bad << " was accepted";
      } catch (const std::invalid_argument& error) {
        const std::string message = error.what(), before = half_long ? "half_long is " : "has coordinate ";
        const std::size_t at = message.find(before);
        ASSERT_NE(at, std::string::npos) << message;
        EXPECT_EQ(std::strtod(message.c_str() + at + before.size(), nullptr), bad) << message;
      }
    }
  }
}

}  // namespace
