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
#include "pyramid.hpp"
#include "rays.hpp"
#include "surface.hpp"

namespace jet {

class FastRoute {
 public:
  /// Allocates the workspace for a surface.
  void prepare(std::span<const Triangle> triangles, std::size_t node_count, bool closed);

  VisibilityCounters query(const Surface& surface, const RaySource& source, std::span<const int> candidates,
                           std::span<std::uint8_t> lit);

 private:
  /// What is certain of an element: it faces all sources and its ray pierces it, or it faces none.
  enum Known : std::uint8_t { kUnknown, kFaces, kTurnedAway };
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

  void reserve(std::size_t element_count, std::size_t node_count);
  std::size_t at(int slot) const { return static_cast<std::size_t>(near_[static_cast<std::size_t>(slot)]); }
  void collect();
  void classify(int slot);
  bool same_side(int element);
  bool source_on_surface(const blocking::Ray& ray);
  bool winding_is_one();
  std::size_t open_uncertain(bool certain);
  std::size_t open_near_away();
  void meet_away(int hit, int element);
  void search(std::size_t k);
  void hide(std::size_t k, int blocker);
  void hide_again();
  void search();
  void search_aside();
  void search_tree();
  VisibilityCounters count(std::span<std::uint8_t> lit) const;

  Surface surface_;
  const RaySource* source_ = nullptr;
  std::span<const int> candidates_;
  bool closed_ = false;
  bool bounded_ = false;  // there are boxes of the rays and of the elements near them
  bool shared_ = true;    // all sources have the same winding number
  std::optional<bool> point_moved_;
  Kernel kernel_;
  RayBundle rays_;
  Pyramid boxes_;              // of near_
  std::vector<float> points_;  // of near_
  std::vector<int> near_;      // elements that can meet a ray
  int near_count_ = 0;
  std::vector<std::uint8_t> facing_bits_, away_bits_;  // of near_
  std::vector<Known> faces_;                           // of all elements
  std::vector<int> away_;      // slots of near_ that are not certain to face all sources
  std::vector<int> blockers_;  // of all elements: what hid it last, or kNone
  std::vector<int> hits_;
  std::vector<State> states_;  // of the candidates
};

}  // namespace jet
