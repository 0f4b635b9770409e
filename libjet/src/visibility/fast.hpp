// SPDX-License-Identifier: Apache-2.0
// The fast route. It rests on crossings of a closed surface counted along a ray, outward minus inward: from a
// source with winding number 1 the sum is 1. If the ray crosses its target outward through the interior,
// anything else on it comes with an inward crossing, so with an element that faces away from the source (a
// closed one: the ray may meet its rim), before or behind the target. Rays that meet no such element are lit.
// The others, and all rays where a condition of this argument is not certain, are tested against every
// element that can be on their segment.
//
// The winding number of a source that lies on the surface is that of source + eps axis, and so is the side of
// an element that holds it; for a source that does not, eps changes neither. So both are taken with eps from
// the start, and whether a source lies on the surface is only asked where an orientation from it is zero.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "jet/visibility.hpp"
#include "visibility/filter.hpp"
#include "visibility/near.hpp"
#include "visibility/rays.hpp"
#include "visibility/surface.hpp"

namespace jet {

class FastRoute {
 public:
  /// Allocates the workspace for a surface.
  void prepare(std::span<const Triangle> triangles, std::size_t node_count, bool closed);

  /// The nodes may have moved: to be said before every query of any route. `displacement_bound`: see
  /// VisibilityQuery.
  void move_to(double displacement_bound) { rays_.move_to(displacement_bound); }

  VisibilityCounters query(const Surface& surface, const RaySource& source, std::span<const int> candidates,
                           std::span<std::uint8_t> lit);

 private:
  enum State : std::uint8_t { kLit = 0, kHidden = 1, kFacingAway = 2, kOpen = 4 };  // see count()
  /// A ray and an element that is on it, or may be, by their places in the mesh's order.
  struct RayHit {
    int ray, element;
  };

  /// Finds out whether a ray's source is moved when the rule asks for it.
  struct Kernel : filter::Kernel {
    FastRoute* route = nullptr;
    bool moved(const blocking::Ray& ray) {
      if (ray.moved == blocking::Moved::unknown)
        ray.moved = blocking::moved_if(route->source_on_surface(ray));
      return ray.moved == blocking::Moved::yes;
    }
  };

  int element(int place) const { return mesh_.elements[static_cast<std::size_t>(place)]; }
  State& state(int place) { return states_[static_cast<std::size_t>(place)]; }
  void set(int place, State state);
  bool alive(int place) const { return (alive_[static_cast<std::size_t>(place / 8)] >> place % 8 & 1) != 0; }
  std::span<const int> list(std::span<const std::uint8_t> bits);
  bool find_near();
  void classify_near();
  void classify_all();
  bool may_face_away(int element);
  bool between_sources(int element);
  bool same_side(int element);
  bool source_on_surface(const blocking::Ray& ray);
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
  VisibilityCounters count(std::span<std::uint8_t> lit) const;

  Surface surface_;
  const RaySource* source_ = nullptr;
  OrderedMesh mesh_;
  bool closed_ = false;
  bool bounded_ = false;   // the rays have boxes, and elements near them are known
  bool any_away_ = false;  // without boxes: some element is not certain to face all sources
  bool shared_ = true;     // all sources have the same winding number
  std::optional<bool> point_moved_;
  Kernel kernel_;
  RayBundle rays_;
  NearElements near_;
  std::vector<int> open_;                           // places of rays that were opened
  std::vector<RayHit> blockers_, cached_blockers_;  // rays and what blocks them; at the last query
  std::vector<RayHit> openers_, cached_openers_;    // rays that an element opened that faces away
  std::vector<int> cached_rays_, cached_elements_;  // rays that may meet elements again, and which
  std::vector<std::uint8_t> blocked_, pierced_, apart_, missed_;
  std::vector<std::uint8_t> alive_;   // by patch: bits of the rays that are lit so far
  std::vector<std::uint8_t> chosen_;  // workspace: bits of rays
  std::vector<int> listed_;
  std::vector<State> states_;  // of the places asked about
};

}  // namespace jet
