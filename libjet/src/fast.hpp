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
// the start, and whether a source lies on the surface is only asked for rays that need the whole rule.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "filter.hpp"
#include "jet/visibility.hpp"
#include "ray_grid.hpp"
#include "rays.hpp"
#include "surface.hpp"

namespace jet {

class FastRoute {
 public:
  /// Allocates the workspace for a surface.
  void prepare(std::size_t element_count, std::size_t node_count, bool closed);

  /// `size` bounds the magnitude of every coordinate of nodes and sources.
  VisibilityCounters query(const Surface& surface, const RaySource& source, double size,
                           std::span<const int> candidates, std::span<std::uint8_t> lit);

 private:
  enum State : std::uint8_t { kLit, kOpen, kHidden, kFacingAway };

  void collect(const Surface& surface);
  void classify(const Surface& surface, const RaySource& source, double size);
  void classify_suspect(const Surface& surface, const RaySource& source, int element);
  bool same_side(const Surface& surface, int element);
  bool winding_is_one(const Surface& surface);
  std::size_t open_uncertain(const Surface& surface, std::span<const int> candidates, double size,
                             bool certain);
  std::size_t open_near_away(const Surface& surface);
  bool resolve(const Surface& surface, const RaySource& source, std::span<const int> candidates);
  void search(const Surface& surface, std::span<const int> candidates);
  void search_aside(const Surface& surface, std::span<const int> candidates);
  void search_tree(const Surface& surface, std::span<const int> candidates);
  bool source_on_suspect(const Surface& surface, const blocking::Ray& ray);

  bool closed_ = false;
  bool shared_ = true;  // all sources have the same winding number
  filter::Kernel kernel_;
  RayBundle bundle_;
  RayGrid grid_;
  std::vector<std::uint16_t> codes_;  // of the nodes, see Funnel
  std::vector<int> near_;             // elements that can meet a ray
  std::vector<int> on_way_;           // those that can meet the way of the winding number
  std::vector<int> away_;             // those near that are not certain to face all sources
  std::vector<int> suspects_;         // those near that can hold a source
  std::vector<State> states_;         // of the candidates
};

}  // namespace jet
