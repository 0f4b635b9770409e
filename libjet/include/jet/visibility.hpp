// SPDX-License-Identifier: Apache-2.0
// Stage S7: which elements of a triangulated surface are lit from a source. Exact on the coordinates as
// given.
//
// Definition (J.7). For a candidate element (a, b, c), in double arithmetic, in this order and without
// contraction:
//   target  g = ((a + b) + c) / 3
//   source  s = centre                                          if half_long = 0 (round outlet), else
//           s = centre + t l, d = g - centre, t = (dx lx + dy ly) + dz lz clamped to +-half_long
// All further predicates are exact:
// - The candidate faces the source if orientation(s, a, b, c) > 0, that is, if the source sees its inner
//   side.
// - An element other than the candidate (by index) blocks if the open segment s g meets its closed triangle
//   and does not lie in its plane. So a degenerate triangle never blocks, and a duplicate of the candidate
//   can.
// - If s lies on a closed element of non-zero area, of any role, then s + eps axis with eps -> 0+ replaces s
//   in every predicate of that ray. An element whose plane contains that ray never blocks.
// - Null and attachment elements never block.
//
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

/// Source of the rays.
struct RaySource {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // [m]
  /// [-] not 0. A source on the surface is moved along it.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
  /// [-] unit vector along the line of sources; used as given, if half_long > 0.
  Eigen::Vector3d long_direction = Eigen::Vector3d::Zero();
  double half_long = 0.0;  // [m] half the outlet's long side; 0: a point source
};

/// Algorithms. All give the same mask, bit for bit.
enum class VisibilityRoute {
  /// Default: float and double arithmetic with error bounds; elements that face away come first.
  fast,
  /// CGAL's AABB tree, built at every call; in the library jet_tree, see jet_tree/tree_route.hpp.
  cgal_tree,
  brute_force  // every pair, by CGAL's predicates: the oracle
};

/// False for cgal_tree unless this program called add_tree_route().
bool has_route(VisibilityRoute route);

/// Elements with a special role. They never block, but count in winding numbers.
struct SurfaceRoles {
  std::vector<int> null_elements;        // close a hole
  std::vector<int> attachment_elements;  // around the outlet
};

/// Counters of one query. candidates = lit + hidden + facing_away.
struct VisibilityCounters {
  std::size_t candidates = 0;   // elements queried
  std::size_t lit = 0;          // face the source, and nothing blocks
  std::size_t hidden = 0;       // face the source, but are blocked
  std::size_t facing_away = 0;  // orientation <= 0
  std::size_t exact_calls = 0;  // predicates by CGAL's kernel; may depend on earlier queries
  /// Fast route: rays that the counting of crossings did not decide, so that the whole rule was tested.
  std::size_t fallbacks = 0;
  /// Trees of boxes that the fast route built, which allocates. It does so for a folded surface with many
  /// rays perpendicular to the axis, and for coordinates above 1e7 extents.
  std::size_t tree_builds = 0;

  VisibilityCounters& operator+=(const VisibilityCounters& other);  // adds the counters of another query
};

/// Visibility on a surface of fixed connectivity. It owns its workspace, which the first query allocates: use
/// one object per thread. Data kept from earlier queries makes the next query faster and changes no mask.
class VisibilityQuery {
 public:
  /// Throws std::invalid_argument for an empty mesh, a node index outside [0, node_count), and a role's
  /// element index out of range.
  VisibilityQuery(const Triangles& triangles, int node_count, const SurfaceRoles& roles = {});
  VisibilityQuery(const VisibilityQuery& other);             // shares the mesh but no data of earlier queries
  VisibilityQuery& operator=(const VisibilityQuery& other);  // likewise
  VisibilityQuery(VisibilityQuery&& other) noexcept;         // leaves `other` without a mesh
  VisibilityQuery& operator=(VisibilityQuery&& other) noexcept;  // likewise
  ~VisibilityQuery();                                            // frees its workspace

  /// Allocates the workspace, so that queries do not.
  void prepare();

  /// Answers from now on as a query on the mesh without these elements, which must not be candidates; an
  /// empty list brings all back. It drops data of earlier queries. Nodes of elements left out are still read
  /// and checked. Throws std::invalid_argument for an element index out of range.
  void leave_out(std::span<const int> elements);

  /// Sets lit[k] to 1 if candidates[k] is lit, else to 0. `nodes` [m] is 3 x node_count.
  ///
  /// `displacement_bound` [m] grows between two queries by at least the motion of every node. The fast route
  /// then reads nodes far from all rays only now and then. The mask is the same, but a coordinate out of
  /// range may be noticed later. Without the bound, and whenever it decreases, it reads all nodes.
  ///
  /// Throws std::invalid_argument for wrong sizes and indices, an unavailable route, and a zero axis. Also
  /// throws it if a coordinate of the source, or of a node that an element uses, is neither 0 nor 1e-100 to
  /// 1e100 in magnitude.
  VisibilityCounters query(VisibilityRoute route, const Points& nodes, const RaySource& source,
                           std::span<const int> candidates, std::span<std::uint8_t> lit,
                           double displacement_bound = kMotionUnknown);

  /// Winding number of the ray source of each candidate; 1 inside a closed outward surface. It is exact;
  /// sources on the surface are moved as above. std::nullopt if the surface is open, the moved source stays
  /// on an element (its plane contains the axis) or no generic ray was found. Meant for checks before a run:
  /// O(M) per candidate, and it allocates.
  std::vector<std::optional<int>> winding_numbers(const Points& nodes, const RaySource& source,
                                                  std::span<const int> candidates);

  int element_count() const;  // M, the number of elements
  /// True if each directed edge occurs as often as its opposite, and no element is left out.
  bool closed() const;

 private:
  struct Mesh;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Mask of all M elements of a mesh seen from `source`, in one call. Throws as VisibilityQuery does.
std::vector<std::uint8_t> visible(const Points& nodes, const Triangles& triangles, const RaySource& source,
                                  VisibilityRoute route = VisibilityRoute::fast);

}  // namespace jet
