// SPDX-License-Identifier: Apache-2.0
// The fast route. It counts crossings of a closed surface along a ray, outward minus inward. From a source
// with winding number 1 the sum is 1. Let the ray cross its target outward, through the interior. Any other
// crossing then needs an inward one, before or behind the target: an element that faces away from the source.
// (The ray may meet only the rim of it.) So a ray that meets no such element is lit. Other rays are tested
// against all elements that can be on their segment, as are rays for which a condition of this argument is
// not certain.
//
// For a source on the surface, winding number and sides are taken at source + eps axis; for other sources eps
// changes neither. So eps is used from the start, and whether a source lies on the surface is tested only
// where an orientation from it is zero.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "jet/visibility.hpp"
#include "visibility/hit_cache.hpp"
#include "visibility/near.hpp"
#include "visibility/ray_states.hpp"
#include "visibility/rays.hpp"
#include "visibility/source_view.hpp"
#include "visibility/surface.hpp"

namespace jet {

/// One query: finds the near elements, sets the state of each ray, and searches blockers for the open rays.
class FastRoute {
 public:
  /// Allocates the workspace for a surface, whose mesh several routes may share.
  void prepare(std::shared_ptr<const OrderedMesh> mesh, std::size_t node_count, bool closed, Way way);

  /// Says that the nodes may have moved; must be called before every query of any route.
  /// `displacement_bound`: see VisibilityQuery.
  void move_to(double displacement_bound) { rays_.move_to(displacement_bound); }

  /// False if more than a few rays do not run downstream: `answer` then takes long.
  bool begin(const Surface& surface, const RaySource& source, std::span<const int> candidates);
  /// Call once after each `begin`, while its arguments are still valid.
  VisibilityCounters answer(std::span<std::uint8_t> lit);

 private:
  using enum RayStates::State;

  /// Facts about the sources and elements of this query.
  struct Facts {
    bool bounded = false;   // the rays have boxes, and the elements near them are known
    bool any_away = false;  // if not bounded: an element may face away from a source
    bool shared = true;     // all sources have the same winding number
  };

  void classify_near();
  void classify_all();
  bool winding_is_one();
  std::size_t open_uncertain(bool certain);
  std::size_t open_near_away();
  void meet_away(int ray, int by, Touch touch);
  void hide(int ray, int by);
  void open(int ray, int by);
  void test_cached_blockers();
  void search();
  void search_upstream();
  void search_tree();

  Surface surface_;
  std::shared_ptr<const OrderedMesh> mesh_;
  bool closed_ = false;
  Facts facts_;
  SourceView view_;
  RayBundle rays_;
  NearElements near_;
  RayStates states_;
  HitCache hits_;
};

}  // namespace jet
