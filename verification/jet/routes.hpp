// SPDX-License-Identifier: Apache-2.0
// Every route asked the same question, in one call.
#pragma once

#include <gtest/gtest.h>

#include <numeric>

#include "jet/visibility.hpp"
#include "jet_tree/tree_route.hpp"
#include "scenes.hpp"

namespace routes {

using Mask = std::vector<std::uint8_t>;

inline const bool kTreeAdded = jet::add_tree_route();
inline constexpr jet::VisibilityRoute kAll[] = {jet::VisibilityRoute::brute_force,
                                                jet::VisibilityRoute::cgal_tree, jet::VisibilityRoute::fast};

inline jet::RaySource point(const Eigen::Vector3d& centre, const Eigen::Vector3d& axis = {1.0, 0.0, 0.0}) {
  jet::RaySource source;
  source.centre = centre;
  source.axis = axis;
  return source;
}

inline jet::RaySource line(const Eigen::Vector3d& centre, const Eigen::Vector3d& axis,
                           const Eigen::Vector3d& along, double half_long) {
  jet::RaySource source = point(centre, axis);
  source.long_direction = along;
  source.half_long = half_long;
  return source;
}

inline std::vector<int> all(std::size_t count) {
  std::vector<int> indices(count);
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

struct Answer {
  Mask lit;
  jet::VisibilityCounters counters;
};

inline Answer ask(jet::VisibilityRoute route, const scenes::Mesh& mesh, const jet::RaySource& source,
                  const std::vector<int>& candidates, const jet::SurfaceRoles& roles = {}) {
  jet::VisibilityQuery query(mesh.triangles(), static_cast<int>(mesh.nodes.size()), roles);
  Answer answer{Mask(candidates.size()), {}};
  answer.counters = query.query(route, mesh.points(), source, candidates, answer.lit);
  return answer;
}

/// Elements whose centroids lie within a cone about the source's axis, cosine of the half angle as given.
inline std::vector<int> in_cone(const scenes::Mesh& mesh, const jet::RaySource& source, double cosine) {
  std::vector<int> candidates;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const Eigen::Vector3d d = mesh.centroid(e) - source.centre;
    if (d.dot(source.axis) > cosine * d.norm() * source.axis.norm())
      candidates.push_back(static_cast<int>(e));
  }
  return candidates;
}

/// The brute-force mask of the candidates, after all the other routes have given the same one. The counters
/// are those of the fast route: apart from exact_calls and fallbacks they are all equal.
inline Answer agreed_on(const std::vector<int>& candidates, const scenes::Mesh& mesh,
                        const jet::RaySource& source, const jet::SurfaceRoles& roles = {}) {
  Answer reference = ask(jet::VisibilityRoute::brute_force, mesh, source, candidates, roles);
  for (const auto route : kAll) {
    const Answer other = ask(route, mesh, source, candidates, roles);
    EXPECT_EQ(other.lit, reference.lit) << "route " << static_cast<int>(route);
    EXPECT_EQ(other.counters.lit, reference.counters.lit);
    EXPECT_EQ(other.counters.hidden, reference.counters.hidden);
    EXPECT_EQ(other.counters.facing_away, reference.counters.facing_away);
    EXPECT_EQ(other.counters.candidates, candidates.size());
    reference.counters = other.counters;
  }
  return reference;
}

/// The same for all elements.
inline Answer agreed(const scenes::Mesh& mesh, const jet::RaySource& source,
                     const jet::SurfaceRoles& roles = {}) {
  return agreed_on(all(mesh.elements.size()), mesh, source, roles);
}

/// One query object over a sequence of steps, each compared with brute force and with an object made for it.
struct Carried {
  explicit Carried(const scenes::Mesh& mesh)
      : query(mesh.triangles(), static_cast<int>(mesh.nodes.size())), hidden(0), candidates(0) {}

  void step(const scenes::Mesh& mesh, const jet::RaySource& source, const std::vector<int>& chosen,
            double displacement_bound = jet::kMotionUnknown) {
    Mask lit(chosen.size());
    const auto counters =
        query.query(jet::VisibilityRoute::fast, mesh.points(), source, chosen, lit, displacement_bound);
    const auto truth = ask(jet::VisibilityRoute::brute_force, mesh, source, chosen);
    EXPECT_EQ(lit, truth.lit);
    EXPECT_EQ(lit, ask(jet::VisibilityRoute::fast, mesh, source, chosen).lit);
    EXPECT_EQ(counters.hidden, truth.counters.hidden);
    EXPECT_EQ(counters.facing_away, truth.counters.facing_away);
    hidden += counters.hidden;
    candidates += chosen.size();
  }

  jet::VisibilityQuery query;
  std::size_t hidden, candidates;
};

}  // namespace routes
