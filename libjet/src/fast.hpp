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

#include "filter.hpp"
#include "jet/visibility.hpp"
#include "near.hpp"
#include "rays.hpp"
#include "surface.hpp"

namespace jet {

class FastRoute {
 public:
  /// Allocates the workspace for a surface.
  void prepare(std::span<const Triangle> triangles, std::size_t node_count, bool closed);

  VisibilityCounters query(const Surface& surface, const RaySource& source, std::span<const int> candidates,
                           std::span<std::uint8_t> lit, double travelled);

 private:
  static constexpr int kNone = -1;
  enum State : std::uint8_t { kLit, kOpen, kHidden, kFacingAway };

  /// Finds out whether a ray's source is moved when the rule asks for it.
  struct Kernel : filter::Kernel {
    FastRoute* route = nullptr;
    bool moved(const blocking::Ray& ray) {
      if (ray.moved == blocking::Moved::unknown)
        ray.moved = blocking::moved_if(route->source_on_surface(ray));
      return ray.moved == blocking::Moved::yes;
    }
  };

  void reserve(std::size_t ray_count, std::size_t node_count);
  int element(int place) const { return mesh_.elements[static_cast<std::size_t>(place)]; }
  int place(std::size_t k) const { return mesh_.rank[static_cast<std::size_t>(candidates_[k])]; }
  void look();
  void look_at_all();
  bool may_face_away(int element);
  bool between_sources(int element);
  bool same_side(int element);
  bool source_on_surface(const blocking::Ray& ray);
  bool winding_is_one();
  std::size_t open_uncertain(bool certain);
  std::size_t open_near_away();
  void meet_away(std::size_t k, int element, int kind);
  void hide(std::size_t k, int blocker);
  void hide_again();
  void search();
  void search(std::size_t k);
  void search_aside();
  void search_tree();
  VisibilityCounters count(std::span<std::uint8_t> lit) const;

  Surface surface_;
  const RaySource* source_ = nullptr;
  OrderedMesh mesh_;
  std::span<const int> candidates_;
  bool closed_ = false;
  bool bounded_ = false;  // the rays have boxes, and elements near them are known
  bool shared_ = true;    // all sources have the same winding number
  std::optional<bool> point_moved_;
  Kernel kernel_;
  RayBundle rays_;
  RayBundle::Way way_;
  NearElements near_;
  std::vector<int> away_;              // places of elements that are not certain to face all sources
  std::vector<int> blockers_;          // of all elements: what hid it last, or kNone
  std::vector<int> again_, again_by_;  // rays to be hidden again, and blockers
  std::vector<std::uint8_t> blocked_, apart_, alive_;
  std::vector<State> states_;  // of the candidates
};

}  // namespace jet
