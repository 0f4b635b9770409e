// SPDX-License-Identifier: Apache-2.0
#include "fast.hpp"

#include <algorithm>

#include "sides.hpp"
#include "winding.hpp"

namespace jet {

void FastRoute::prepare(std::span<const Triangle> triangles, std::size_t node_count, bool closed) {
  closed_ = closed;
  mesh_ = OrderedMesh(triangles);
  near_.reserve(mesh_);
  away_.reserve(triangles.size());
  blockers_.assign(triangles.size(), kNone);
  reserve(triangles.size(), node_count);
}

void FastRoute::reserve(std::size_t ray_count, std::size_t node_count) {
  rays_.reserve(mesh_, ray_count, node_count);
  again_.resize(ray_count);
  again_by_.resize(ray_count);
  for (auto* bytes : {&blocked_, &apart_, &alive_}) bytes->resize(ray_count / 8 + 1);
  states_.reserve(ray_count);
}

VisibilityCounters FastRoute::query(const Surface& surface, const RaySource& source,
                                    std::span<const int> candidates, std::span<std::uint8_t> lit,
                                    double travelled) {
  if (candidates.size() > states_.capacity())  // some are named twice
    reserve(candidates.size(), static_cast<std::size_t>(surface.node_count));
  surface_ = surface;
  source_ = &source;
  kernel_.calls = 0;
  kernel_.route = this;
  point_moved_.reset();
  bounded_ = rays_.build(surface, source, candidates, travelled);
  candidates_ = rays_.candidates;
  bounded_ ? look() : look_at_all();
  const bool certain = closed_ && shared_ && winding_is_one();
  std::size_t fallbacks = open_uncertain(certain), trees = 0;
  if (bounded_) hide_again();
  if (certain && !away_.empty()) fallbacks += open_near_away();
  if (bounded_) {
    search();
  } else if (std::find(states_.begin(), states_.end(), kOpen) != states_.end()) {
    search_tree();
    trees = 1;
  }
  VisibilityCounters counters = count(lit);
  counters.fallbacks = fallbacks;
  counters.tree_builds = trees;
  return counters;
}

VisibilityCounters FastRoute::count(std::span<std::uint8_t> lit) const {
  VisibilityCounters counters;
  counters.candidates = candidates_.size();
  for (std::size_t k = 0; k < candidates_.size(); ++k) {
    lit[static_cast<std::size_t>(rays_.given[k])] = states_[k] == kLit;
    counters.lit += states_[k] == kLit;
    counters.hidden += states_[k] == kHidden;
    counters.facing_away += states_[k] == kFacingAway;
  }
  counters.exact_calls = kernel_.calls;
  return counters;
}

// Elements near the rays that may face away.
void FastRoute::look() {
  away_.clear();
  shared_ = true;
  way_ = rays_.way();
  near_.find(rays_, way_);
  near_.for_each_not_inner([&](int place) {
    if (near_.shows_outer_side(place) || may_face_away(element(place))) away_.push_back(place);
  });
  near_.for_each_between([&](int place) { shared_ = shared_ && !between_sources(element(place)); });
}

void FastRoute::look_at_all() {
  away_.clear();
  shared_ = true;
  for (int place = 0; place < surface_.count; ++place) {
    if (may_face_away(element(place))) away_.push_back(place);
    shared_ = shared_ && !between_sources(element(place));
  }
}

// What rounding, or the outlet's length, leaves open counts as facing away.
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

// Not certain that all sources, moved by eps, are on one side of the element's plane.
bool FastRoute::between_sources(int element) {
  if (source_->half_long == 0.0 || common_side(surface_, element, *source_, rays_.size) != 0) return false;
  if (!in_one_coordinate_plane(surface_, element, *source_)) return !same_side(element);
  return kernel_.slope(source_->axis.data(), surface_.corner(element, 0), surface_.corner(element, 1),
                       surface_.corner(element, 2)) == 0;
}

// No way from one source to another crosses the element's plane.
bool FastRoute::same_side(int element) {
  int common = 0;
  for (std::size_t k = 0; k < candidates_.size(); ++k) {
    blocking::Ray ray = rays_.ray(k);
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
    near_.for_each_on_way([&](int place) {
      const auto part = winding::crossing(kernel_, way_.ray, surface_, element(place));
      generic = generic && part.has_value();
      sum += part.value_or(0);
    });
    if (generic) return sum == 1;
  }
  blocking::Ray from = rays_.ray(0);
  from.moved = blocking::Moved::yes;
  return winding::number(kernel_, from, surface_, winding::bounding_box(surface_)) == 1;
}

// Rays for which the argument of fast.hpp does not hold for certain are open; the number of those that may be
// lit is returned.
std::size_t FastRoute::open_uncertain(bool certain) {
  states_.assign(candidates_.size(), kLit);
  std::size_t open = 0;
  for (std::size_t k = 0; k < candidates_.size(); ++k) {
    if (certain && bounded_ && near_.shows_inner_side(place(k))) continue;
    if (bounded_ && near_.shows_outer_side(place(k))) {
      states_[k] = kFacingAway;
      continue;
    }
    const int e = candidates_[k];
    const blocking::Ray& ray = rays_.ray(k);
    if (certain && surely_pierces(surface_, e, ray.source, rays_.size)) continue;
    if (blocking::facing(kernel_, ray, surface_, e) <= 0) {
      states_[k] = kFacingAway;
    } else if (!certain || !blocking::passage(kernel_, ray, surface_, e).pierces()) {
      states_[k] = kOpen;
      ++open;
    }
  }
  if (!bounded_) return open;
  for (const std::uint32_t k : rays_.aside) {  // elements beside the other rays were not looked at
    if (states_[k] != kLit) continue;
    states_[k] = kOpen;
    ++open;
  }
  return open;
}

}  // namespace jet
