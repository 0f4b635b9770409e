// SPDX-License-Identifier: Apache-2.0
// Shared by the reference routes: a loop over single candidates, and the hook for the route of jet_tree.
#pragma once

#include <span>

#include "visibility/blocking.hpp"

namespace jet {

/// Queries candidates one by one; `search` tests the whole surface.
template <class Search>
VisibilityCounters query_by(const Search& search, const Surface& surface, const RaySource& source,
                            std::span<const int> candidates, std::span<std::uint8_t> lit) {
  VisibilityCounters counters;
  auto point_moved = blocking::Moved::no;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    blocking::Ray ray = blocking::make_ray(surface, candidates[k], source);
    const bool shared = source.half_long == 0.0 && k > 0;  // a point source is located once
    point_moved = ray.moved = shared ? point_moved : blocking::moved_if(search.source_on_surface(ray));
    const bool faces = blocking::facing(search.kernel, ray, surface, candidates[k]) > 0;
    lit[k] = faces && !search.blocked(ray, candidates[k]);
    counters.facing_away += !faces;
    counters.lit += lit[k];
  }
  counters.candidates = candidates.size();
  counters.hidden = counters.candidates - counters.lit - counters.facing_away;
  counters.exact_calls = search.kernel.calls;
  return counters;
}

/// A route of another library.
using OtherRoute = VisibilityCounters (*)(const Surface&, const RaySource&, std::span<const int>,
                                          std::span<std::uint8_t>);
/// Makes `route` VisibilityRoute::cgal_tree.
void set_tree_route(OtherRoute route);

}  // namespace jet
