// SPDX-License-Identifier: Apache-2.0
#include "visibility/fast.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include "bits.hpp"
#include "visibility/sides.hpp"
#include "visibility/winding.hpp"

namespace jet {

void FastRoute::prepare(std::span<const Triangle> triangles, std::size_t node_count, bool closed) {
  closed_ = closed;
  mesh_ = OrderedMesh(triangles);
  near_.reserve(mesh_);
  rays_.reserve(mesh_, node_count);
  const std::size_t patches = rays_.asked().size(), elements = 8 * patches;
  open_.reserve(elements);
  for (auto* places : {&cached_rays_, &cached_elements_})
    places->resize(2 * elements + 1);  // by what hid them, what opened them
  for (auto* met : {&blockers_, &cached_blockers_, &openers_, &cached_openers_}) met->reserve(elements);
  for (auto* bytes : {&alive_, &chosen_}) bytes->resize(patches);
  for (auto* bytes : {&blocked_, &pierced_, &apart_, &missed_}) bytes->resize(2 * patches);
  listed_.resize(elements + 8);
  states_.resize(elements);
}

VisibilityCounters FastRoute::query(const Surface& surface, const RaySource& source,
                                    std::span<const int> candidates, std::span<std::uint8_t> lit) {
  surface_ = surface;
  source_ = &source;
  kernel_.calls = 0;
  kernel_.route = this;
  point_moved_.reset();
  rays_.ask(surface, source, candidates);
  std::fill(states_.begin(), states_.end(), kLit);
  std::copy(rays_.asked().begin(), rays_.asked().end(), alive_.begin());
  open_.clear();
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
  } else if (!open_.empty()) {
    search_tree();
    trees = 1;
  }
  VisibilityCounters counters = count(lit);
  counters.fallbacks = fallbacks;
  counters.tree_builds = trees;
  return counters;
}

void FastRoute::set(int place, State state) {
  this->state(place) = state;
  std::uint8_t& bits = alive_[static_cast<std::size_t>(place / 8)];
  bits = static_cast<std::uint8_t>(bits & ~(1 << place % 8));
  if (state == kOpen) open_.push_back(place);
}

std::span<const int> FastRoute::list(std::span<const std::uint8_t> bits) {
  const int count = kernel_table().list_bits(bits.data(), static_cast<int>(bits.size()), listed_.data());
  return std::span(listed_).first(static_cast<std::size_t>(count));
}

// Bytes of states are told apart by their bits, eight at a time.
VisibilityCounters FastRoute::count(std::span<std::uint8_t> lit) const {
  VisibilityCounters counters;
  const State* states = states_.data();  // which the bytes written cannot change
  std::uint8_t* to = lit.data();
  for (const int place : rays_.places()) *to++ = states[place];
  const auto take = [&](std::uint8_t* bytes, std::size_t count) {
    constexpr std::uint64_t ones = 0x0101010101010101u;
    std::uint64_t x = 0;
    std::memcpy(&x, bytes, count);
    counters.hidden += (x & ones) * ones >> 56;
    counters.facing_away += (x >> 1 & ones) * ones >> 56;
    x = ~(x | x >> 1) & ones;
    std::memcpy(bytes, &x, count);
  };
  static_assert(kHidden == 1 && kFacingAway == 2 && std::endian::native == std::endian::little);
  std::size_t i = 0;
  for (; i + 8 <= lit.size(); i += 8) take(&lit[i], 8);
  if (i < lit.size()) take(&lit[i], lit.size() - i);
  counters.candidates = lit.size();
  counters.lit = counters.candidates - counters.hidden - counters.facing_away;
  counters.exact_calls = kernel_.calls;
  return counters;
}

bool FastRoute::find_near() {
  near_.find(rays_);
  return rays_.accept(near_.found(), near_.patches(), near_.upstream());
}

// Of the elements near the rays that may show either side, those that face all sources are sorted out.
void FastRoute::classify_near() {
  shared_ = true;
  for (const int place : near_.uncertain())
    if (!may_face_away(element(place))) near_.rule_out_outer_side(place);
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
  if (certain && bounded_) and_not(alive_, near_.inner(), chosen_);
  for (const int place : list(certain && bounded_ ? chosen_ : alive_)) {
    if (bounded_ && near_.shows_outer_side(place)) {
      set(place, kFacingAway);
      continue;
    }
    const int e = element(place);
    const blocking::Ray& ray = rays_.ray(place);
    if (certain && surely_pierces(surface_, e, ray.source, rays_.size)) continue;
    if (blocking::facing(kernel_, ray, surface_, e) <= 0) {
      set(place, kFacingAway);
    } else if (!certain || !blocking::passage(kernel_, ray, surface_, e).pierces()) {
      set(place, kOpen);
    }
  }
  for (const int place : rays_.upstream)  // elements beside the other rays were not looked at
    if (state(place) == kLit) set(place, kOpen);
  return open_.size();
}

}  // namespace jet
