// SPDX-License-Identifier: Apache-2.0
// Stage S5: which elements of a triangulated surface are lit from a source. Exact on the coordinates as
// given.
//
// Definition (J.7). For a candidate element (a, b, c) in double arithmetic, in this order, without
// contraction:
//   target  g = ((a + b) + c) / 3
//   source  s = centre                                          if half_long = 0 (round outlet), else
//           s = centre + t l, d = g - centre, t = (dx lx + dy ly) + dz lz clamped to +-half_long
// From there on all predicates are those of exact arithmetic:
// - facing: orientation(s, a, b, c) > 0, the side of the inward normal is seen;
// - an element other than the candidate (by index) blocks if the open segment s g meets its closed triangle
//   and does not lie in its plane; so degenerate triangles never block, a duplicate of the candidate can;
// - if s lies on a closed element of non-zero area, whichever role it has, s + eps axis with eps -> 0+
//   stands for s in every predicate of that ray, and an element whose plane holds that ray never blocks;
// - null and attachment elements never block.
// A candidate is lit if it faces the source and nothing blocks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "jet/views.hpp"

namespace jet {

/// Where rays start.
struct RaySource {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();          // [m]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();           // [-] a source on the surface is moved so; not 0
  Eigen::Vector3d long_direction = Eigen::Vector3d::Zero();  // [-] unit, read if half_long > 0; as given
  double half_long = 0.0;                                    // [m] half the outlet's long side; 0: a point
};

/// Ways to the same answer, bit for bit.
enum class VisibilityRoute {
  fast,        // float and double arithmetic with error bounds, away-facing elements first (default)
  cgal_tree,   // CGAL's AABB tree, built anew at every call
  brute_force  // every pair, CGAL's predicates: the oracle
};

/// Elements with a special part.
struct SurfaceRoles {
  std::vector<int> null_elements;        // close a hole: never block, count in winding numbers
  std::vector<int> attachment_elements;  // around the outlet: never block, count in winding numbers
};

/// What a query did. candidates = lit + hidden + facing_away.
struct VisibilityCounters {
  std::size_t candidates = 0;   // elements asked about
  std::size_t lit = 0;          // facing the source, nothing between
  std::size_t hidden = 0;       // facing the source, but blocked
  std::size_t facing_away = 0;  // orientation <= 0
  std::size_t exact_calls = 0;  // predicates left to CGAL's kernel; may depend on earlier queries
  // Of the fast route: rays that needed more than its short cut, that is tests of the whole rule where an
  // argument of the short cut was not certain.
  std::size_t fallbacks = 0;
  // 1 where CGAL's tree was built, which allocates: by the fast route for a folded surface with many rays
  // upstream, and for coordinates above 1e7 extents.
  std::size_t tree_builds = 0;
};

/// Visibility on a surface of fixed connectivity. Owns its workspace: one object a thread. What it keeps from
/// earlier queries makes the next one faster and shows in no mask.
class VisibilityQuery {
 public:
  /// Throws std::invalid_argument for an empty mesh, a node index outside [0, node_count), a role's element
  /// index out of range.
  VisibilityQuery(const Triangles& triangles, int node_count, const SurfaceRoles& roles = {});
  ~VisibilityQuery();
  VisibilityQuery(VisibilityQuery&&) noexcept;
  VisibilityQuery& operator=(VisibilityQuery&&) noexcept;

  /// lit[k] = 1 if candidates[k] is lit, else 0. `nodes` [m] 3 x node_count; coordinates of the source and of
  /// nodes that elements use must be 0 or 1e-100 to 1e100 in magnitude, axis not zero, else
  /// std::invalid_argument; so for wrong sizes and indices. `displacement_bound` [m]: between two queries no
  /// node moves farther than it grows by. The fast route then looks from time to time only at nodes far from
  /// all rays, at their coordinates' range, too, and whether others are below 1e-100; the mask is the same.
  /// Without it, and whenever it decreases, it looks at all.
  VisibilityCounters query(VisibilityRoute route, const Points& nodes, const RaySource& source,
                           std::span<const int> candidates, std::span<std::uint8_t> lit,
                           double displacement_bound = kMotionUnknown);

  /// Winding number of each candidate's ray source (moved as above where it lies on the surface): 1 inside a
  /// closed outward surface. Exact; std::nullopt where the surface is open, the moved source stays on an
  /// element (its plane holds the axis) or no generic ray was found. Meant for checks before a run: O(M) for
  /// each candidate, allocates.
  std::vector<std::optional<int>> winding_numbers(const Points& nodes, const RaySource& source,
                                                  std::span<const int> candidates);

  int element_count() const;  // M of the surface
  bool closed() const;        // every directed edge has its opposite equally often

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Mask of all M elements of a mesh seen from `source`, in one call. Throws as VisibilityQuery.
std::vector<std::uint8_t> visible(const Points& nodes, const Triangles& triangles, const RaySource& source,
                                  VisibilityRoute route = VisibilityRoute::fast);

}  // namespace jet
