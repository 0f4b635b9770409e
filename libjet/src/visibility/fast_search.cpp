// SPDX-License-Identifier: Apache-2.0
// The fast route, second part: rays that meet elements facing away, and the whole rule for those left open.
#include <algorithm>

#include "visibility/box_tree.hpp"
#include "visibility/fast.hpp"
#include "visibility/sides.hpp"

namespace jet {

// Rays that meet an element facing away. Returns the number of those opened without being looked at.
std::size_t FastRoute::open_near_away() {
  if (!bounded_ && !any_away_) return 0;
  const std::span<const int> rays = list(alive_);
  if (bounded_) {
    near_.for_each_touching(rays_, rays, [&](int ray, int by, Touch touch) {
      if (state(ray) == kLit) meet_away(ray, by, touch);
    });
    return 0;
  }
  for (const int ray : rays) set(ray, kOpen);
  return rays.size();
}

// One ray and one element that faces away and may be on it. If it is, and blocks, the ray need not be
// searched.
void FastRoute::meet_away(int ray, int by, Touch touch) {
  const int e = element(by);
  const bool can_block = e != element(ray) && !surface_.never_blocks(e);
  bool hides = can_block && touch == Touch::blocked;
  if (touch == Touch::possible) {
    const blocking::Ray& segment = rays_.ray(ray);
    if (!blocking::passage(kernel_, segment, surface_, e).touches()) return;
    hides = can_block && blocking::blocks(kernel_, segment, surface_, e);
  }
  hides ? hide(ray, by) : open(ray, by);
}

// Open rays against the elements that can be on them.
void FastRoute::search() {
  if (!rays_.upstream.empty()) search_upstream();
  std::fill(chosen_.begin(), chosen_.end(), std::uint8_t{0});
  for (const int ray : open_) {
    std::uint8_t& bits = chosen_[static_cast<std::size_t>(ray / 8)];
    bits = static_cast<std::uint8_t>(bits | int{state(ray) == kOpen} << ray % 8);
  }
  const std::span<const int> rays = list(chosen_);  // eight by eight, neighbours together
  if (rays.empty()) return;
  near_.for_each_before_target(rays_, rays, [&](int ray, int by, Touch touch) {
    const int e = element(by);
    // Its own element may be among them: the mesh's last one stands at several places.
    if (state(ray) != kOpen || e == element(ray) || surface_.never_blocks(e)) return;
    if (touch == Touch::blocked || blocking::blocks(kernel_, rays_.ray(ray), surface_, e)) hide(ray, by);
  });
  for (const int ray : open_)
    if (state(ray) == kOpen) state(ray) = kLit;
}

void FastRoute::hide(int ray, int by) {
  set(ray, kHidden);
  blockers_.push_back({ray, by});
}

void FastRoute::open(int ray, int by) {
  set(ray, kOpen);
  openers_.push_back({ray, by});
}

// What blocked an element's ray at the last query often blocks it again, and what opened it opens it again. A
// ray opened in vain costs a search, so that is not asked exactly.
void FastRoute::test_cached_blockers() {
  std::swap(blockers_, cached_blockers_);
  std::swap(openers_, cached_openers_);
  blockers_.clear();
  openers_.clear();
  std::size_t count = 0;
  const auto ask_if = [&](int wanted, const RayHit& hit) {  // no branch to predict
    cached_rays_[count] = hit.ray;
    cached_elements_[count] = hit.element;
    count += static_cast<std::size_t>(wanted);
  };
  for (const RayHit& hit : cached_blockers_) ask_if(int{alive(hit.ray)} & int{rays_.knows(hit.element)}, hit);
  const std::size_t hidden = count;
  for (const RayHit& hit : cached_openers_)
    ask_if(int{alive(hit.ray)} & int{near_.may_show_outer_side(hit.element)}, hit);
  kernel_table().meet_pairs(
      {rays_.targets(), rays_.local(), rays_.half_long(), mesh_.corner_rows.data(), cached_rays_.data(),
       cached_elements_.data(), blocked_.data(), pierced_.data(), apart_.data(), missed_.data()},
      static_cast<int>(count));
  const auto bit = [](const std::vector<std::uint8_t>& bits, std::size_t i) {
    return (bits[i / 8] >> i % 8 & 1u) != 0;
  };
  for (std::size_t i = 0; i < hidden; ++i) {
    const int ray = cached_rays_[i], by = cached_elements_[i];
    if (bit(blocked_, i) ||
        (!bit(apart_, i) && blocking::blocks(kernel_, rays_.ray(ray), surface_, element(by))))
      hide(ray, by);
  }
  for (std::size_t i = hidden; i < count; ++i)
    if (alive(cached_rays_[i]) && !bit(missed_, i)) open(cached_rays_[i], cached_elements_[i]);
}

// The few rays without bounds, against all elements.
void FastRoute::search_upstream() {
  for (const int place : rays_.upstream) {
    if (state(place) != kOpen) continue;
    const blocking::Ray& ray = rays_.ray(place);
    state(place) = kLit;
    for (int e = 0; e < surface_.count && state(place) == kLit; ++e) {
      if (e == element(place) || surface_.never_blocks(e) || Box(surface_, e).apart_from_segment(ray))
        continue;
      if (blocking::blocks(kernel_, ray, surface_, e)) state(place) = kHidden;
    }
  }
}

void FastRoute::search_tree() {
  const BoxTree tree(surface_);
  for (const int place : open_) {
    if (state(place) != kOpen) continue;
    const blocking::Ray& ray = rays_.ray(place);
    const bool hidden = tree.any(ray, [&](int e) {
      return e != element(place) && !surface_.never_blocks(e) && blocking::blocks(kernel_, ray, surface_, e);
    });
    state(place) = hidden ? kHidden : kLit;
  }
}

}  // namespace jet
