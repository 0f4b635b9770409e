// SPDX-License-Identifier: Apache-2.0
#include "fast.hpp"

#include <cmath>
#include <numeric>

#include "sides.hpp"
#include "winding.hpp"

namespace jet {

void FastRoute::prepare(std::span<const Triangle> triangles, std::size_t node_count, bool closed) {
  closed_ = closed;
  rays_.set_mesh(triangles);
  blockers_.assign(triangles.size(), kNone);
  reserve(triangles.size(), node_count);
}

void FastRoute::reserve(std::size_t element_count, std::size_t node_count) {
  rays_.reserve(element_count, node_count);
  boxes_.reserve(element_count);
  away_.reserve(element_count);
  hits_.resize(element_count);
  near_.resize(element_count + 8);
  points_.resize(kElementFloats * (element_count / 8 + 1));
  facing_bits_.resize(element_count / 8 + 1);
  away_bits_.resize(element_count / 8 + 1);
  faces_.resize(element_count);
  states_.reserve(element_count);
}

VisibilityCounters FastRoute::query(const Surface& surface, const RaySource& source,
                                    std::span<const int> candidates, std::span<std::uint8_t> lit) {
  if (candidates.size() > states_.capacity())  // some are named twice
    reserve(candidates.size(), static_cast<std::size_t>(surface.node_count));
  surface_ = surface;
  source_ = &source;
  kernel_.calls = 0;
  kernel_.route = this;
  point_moved_.reset();
  bounded_ = rays_.build(surface, source, candidates);
  candidates_ = rays_.candidates;
  collect();
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

// Elements near the rays, and those among them that may face away.
void FastRoute::collect() {
  for (int slot = 0; slot < near_count_; ++slot) faces_[at(slot)] = kUnknown;
  away_.clear();
  shared_ = true;
  if (!bounded_) {
    near_count_ = surface_.count;
    std::iota(near_.begin(), near_.begin() + near_count_, 0);
    for (int slot = 0; slot < near_count_; ++slot) classify(slot);
    return;
  }
  near_count_ = rays_.collect(near_.data());
  rays_.element_boxes(near_.data(), near_count_, boxes_.boxes(), points_.data(), facing_bits_.data(),
                      away_bits_.data());
  for (int slot = 0; slot < near_count_; slot += 8) {
    const auto block = static_cast<std::size_t>(slot / 8);
    const unsigned bits = facing_bits_[block], away = away_bits_[block];
    for (int i = slot; i < std::min(slot + 8, near_count_); ++i) {
      const bool faces = (bits >> (i - slot) & 1u) != 0;
      faces_[at(i)] = faces ? kFaces : kUnknown;
      if (faces) continue;
      if ((away >> (i - slot) & 1u) != 0) {
        faces_[at(i)] = kTurnedAway;
        away_.push_back(i);
      } else {
        classify(i);
      }
    }
  }
  boxes_.build(near_count_);
  rays_.boxes.build(static_cast<int>(candidates_.size()));
}

// The sources' sides of an element that floats left open; one that rounding, or the outlet's length, leaves
// open again counts as facing away.
void FastRoute::classify(int slot) {
  const int element = near_[static_cast<std::size_t>(slot)];
  int side = common_side(surface_, element, *source_, rays_.size);
  if (side > 0) return;
  if (side == 0) {
    const bool flat = in_one_coordinate_plane(surface_, element, *source_);
    if (!flat && source_->half_long > 0.0) {
      shared_ = shared_ && ((bounded_ && rays_.beside_sources(element)) || same_side(element));
    } else {
      const double *a = surface_.corner(element, 0), *b = surface_.corner(element, 1),
                   *c = surface_.corner(element, 2);
      side = flat ? 0 : kernel_.orientation(source_->centre.data(), a, b, c);
      if (side == 0) {
        side = -kernel_.slope(source_->axis.data(), a, b, c);
        shared_ = shared_ && (side != 0 || source_->half_long == 0.0);
      }
      if (side >= 0) return;
    }
  }
  away_.push_back(slot);
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
    float box[4];
    const blocking::Ray way = rays_.way(box);
    int sum = 0;
    bool generic = true;
    for (int i = kernel_table().overlap(boxes_.view(), box, hits_.data()); i > 0; --i) {
      const int slot = hits_[static_cast<std::size_t>(i - 1)] / kHitKinds;
      const auto part = winding::crossing(kernel_, way, surface_, near_[static_cast<std::size_t>(slot)]);
      generic = generic && part.has_value();
      sum += part.value_or(0);
    }
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
    const int e = candidates_[k];
    const Known known = faces_[static_cast<std::size_t>(e)];
    if (known == kTurnedAway) states_[k] = kFacingAway;
    if (known == kTurnedAway || (certain && known == kFaces)) continue;
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
