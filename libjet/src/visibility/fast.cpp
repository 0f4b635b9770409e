// SPDX-License-Identifier: Apache-2.0
#include "visibility/fast.hpp"

#include <algorithm>

#include "visibility/sides.hpp"
#include "visibility/winding.hpp"

namespace jet {

void FastRoute::prepare(std::span<const Triangle> triangles, std::size_t node_count, bool closed) {
  closed_ = closed;
  mesh_ = OrderedMesh(triangles);
  near_.reserve(mesh_);
  rays_.reserve(mesh_, node_count);
  states_.reserve(rays_.asked().size());
  hits_.reserve(rays_.asked().size());
}

VisibilityCounters FastRoute::query(const Surface& surface, const RaySource& source,
                                    std::span<const int> candidates, std::span<std::uint8_t> lit) {
  surface_ = surface;
  source_ = &source;
  kernel_.calls = 0;
  kernel_.route = this;
  point_moved_.reset();
  rays_.ask(surface, source, candidates);
  states_.reset(rays_.asked());
  bounded_ = (rays_.project_expected() && find_near()) || (rays_.project_chosen() && find_near()) ||
             (rays_.project_fresh() && find_near());
  if (!bounded_) rays_.do_without();
  bounded_ ? classify_near() : classify_all();
  const bool certain = closed_ && shared_ && winding_is_one();
  std::size_t fallbacks = open_uncertain(certain), trees = 0;
  if (bounded_) test_cached_blockers();
  if (certain) fallbacks += open_near_away();
  if (bounded_) {
    search();
  } else if (!states_.opened().empty()) {
    search_tree();
    trees = 1;
  }
  VisibilityCounters counters = states_.count(rays_.places(), lit);
  counters.exact_calls = kernel_.calls;
  counters.fallbacks = fallbacks;
  counters.tree_builds = trees;
  return counters;
}

bool FastRoute::find_near() {
  near_.find(rays_);
  return rays_.accept(near_.found(), near_.patches(), near_.upstream());
}

// Rules out the near elements that face all sources, though their side was not certain.
void FastRoute::classify_near() {
  shared_ = true;
  for (const int place : near_.uncertain())
    if (!may_face_away(element(place))) near_.sides().rule_out_outer(place);
  for (const int place : near_.between()) shared_ = shared_ && !between_sources(element(place));
}

void FastRoute::classify_all() {
  any_away_ = false;
  shared_ = true;
  for (int place = 0; place < surface_.count; ++place) {
    any_away_ = any_away_ || may_face_away(element(place));
    shared_ = shared_ && !between_sources(element(place));
  }
}

// An element counts as facing away if rounding, or the outlet's length, leaves its side open.
bool FastRoute::may_face_away(int element) {
  int side = common_side(surface_, element, *source_, rays_.size);
  if (side != 0) return side < 0;
  const bool flat = in_one_coordinate_plane(surface_, element, *source_);
  if (!flat && source_->half_long > 0.0) return true;
  const double *a = surface_.corner(element, 0), *b = surface_.corner(element, 1),
               *c = surface_.corner(element, 2);
  if (!flat) side = kernel_.orientation(source_->centre.data(), a, b, c);
  if (side == 0) side = -kernel_.slope(source_->axis.data(), a, b, c);
  return side < 0;
}

// True unless all sources, moved by eps, are certainly on one side of the element's plane.
bool FastRoute::between_sources(int element) {
  if (source_->half_long == 0.0 || common_side(surface_, element, *source_, rays_.size) != 0) return false;
  if (!in_one_coordinate_plane(surface_, element, *source_)) return !same_side(element);
  return kernel_.slope(source_->axis.data(), surface_.corner(element, 0), surface_.corner(element, 1),
                       surface_.corner(element, 2)) == 0;
}

// True if no segment between two sources crosses the element's plane.
bool FastRoute::same_side(int element) {
  int common = 0;
  for (const int place : rays_.places()) {
    blocking::Ray ray = rays_.ray(place);
    ray.moved = blocking::Moved::yes;
    const int side = blocking::facing(kernel_, ray, surface_, element);
    if (side == 0 || side == -common) return false;
    common = side;
  }
  return true;
}

bool FastRoute::source_on_surface(const blocking::Ray& ray) {
  if (source_->half_long == 0.0 && point_moved_) return *point_moved_;
  bool on = false;
  for (int e = 0; e < surface_.count && !on; ++e)
    on = Box(surface_, e).holds(ray.source) && blocking::source_on(kernel_, ray, surface_, e);
  point_moved_ = on;
  return on;
}

bool FastRoute::winding_is_one() {
  if (bounded_) {
    int sum = 0;
    bool generic = true;
    for (const int place : near_.on_winding_ray()) {
      const auto part = winding::crossing(kernel_, rays_.winding_ray(), surface_, element(place));
      generic = generic && part.has_value();
      sum += part.value_or(0);
    }
    if (generic) return sum == 1;
  }
  blocking::Ray from = rays_.ray(rays_.places().front());
  from.moved = blocking::Moved::yes;
  return winding::number(kernel_, from, surface_, winding::bounding_box(surface_)) == 1;
}

// Rays for which the argument of fast.hpp does not hold for certain are open; the number of those that may be
// lit is returned.
std::size_t FastRoute::open_uncertain(bool certain) {
  const auto rays = certain && bounded_ ? states_.list_alive(near_.sides().inner) : states_.list_alive();
  for (const int place : rays) {
    if (bounded_ && ShownSides::has(near_.sides().outer, place)) {
      states_.set(place, kFacingAway);
      continue;
    }
    const int e = element(place);
    const blocking::Ray& ray = rays_.ray(place);
    if (certain && surely_pierces(surface_, e, ray.source, rays_.size)) continue;
    if (blocking::facing(kernel_, ray, surface_, e) <= 0) {
      states_.set(place, kFacingAway);
    } else if (!certain || !blocking::passage(kernel_, ray, surface_, e).pierces()) {
      states_.set(place, kOpen);
    }
  }
  for (const int place : rays_.upstream)  // elements beside the other rays were not looked at
    if (states_[place] == kLit) states_.set(place, kOpen);
  return states_.opened().size();
}

}  // namespace jet
