// SPDX-License-Identifier: Apache-2.0
// The fast route, second part: rays that meet elements facing away, and the whole rule for those left open.
#include <algorithm>

#include "fast.hpp"
#include "sides.hpp"
#include "tree.hpp"

namespace jet {

// Rays that meet an element facing away. Returns the number of those opened without being looked at.
std::size_t FastRoute::open_near_away() {
  if (!bounded_) {
    const auto unseen = std::count(states_.begin(), states_.end(), kLit);
    std::replace(states_.begin(), states_.end(), kLit, kOpen);
    return static_cast<std::size_t>(unseen);
  }
  const std::size_t blocks = (states_.size() + 7) / 8;
  std::fill_n(alive_.begin(), blocks, std::uint8_t{0});
  for (std::size_t k = 0; k < states_.size(); ++k)
    alive_[k / 8] = static_cast<std::uint8_t>(alive_[k / 8] | (states_[k] == kLit) << k % 8);
  near_.for_each_touching(rays_, std::span(alive_).first(blocks), away_,
                          [&](std::size_t k, int place, int kind) {
                            if (states_[k] == kLit) meet_away(k, element(place), kind);
                          });
  return 0;
}

// One ray and one element that faces away and may be on it. If it is, and blocks, the ray need not be
// searched.
void FastRoute::meet_away(std::size_t k, int element, int kind) {
  const bool can_block = element != candidates_[k] && !surface_.never_blocks(element);
  bool hides = can_block && kind == kBlocked;
  if (kind == 0) {
    const blocking::Ray& ray = rays_.ray(k);
    if (!blocking::passage(kernel_, ray, surface_, element).touches()) return;
    hides = can_block && blocking::blocks(kernel_, ray, surface_, element);
  }
  hides ? hide(k, element) : void(states_[k] = kOpen);
}

// Open rays against the elements that can be on them.
void FastRoute::search() {
  if (!rays_.aside.empty()) search_aside();
  for (std::size_t k = 0; k < candidates_.size(); ++k) {
    if (states_[k] == kOpen) search(k);
  }
}

void FastRoute::search(std::size_t k) {
  const bool hidden = near_.any_before_target(rays_, k, [&](int place, int kind) {
    const int e = element(place);
    if (e == candidates_[k] || surface_.never_blocks(e)) return false;
    if (kind != kBlocked && !blocking::blocks(kernel_, rays_.ray(k), surface_, e)) return false;
    hide(k, e);
    return true;
  });
  if (!hidden) states_[k] = kLit;
}

void FastRoute::hide(std::size_t k, int blocker) {
  states_[k] = kHidden;
  blockers_[static_cast<std::size_t>(candidates_[k])] = blocker;
  rays_.drop(k);
}

// What blocked an element's ray at the last query often does so again.
void FastRoute::hide_again() {
  int count = 0;
  for (std::size_t k = 0; k < candidates_.size(); ++k) {
    const int blocker = blockers_[static_cast<std::size_t>(candidates_[k])];
    if (states_[k] == kFacingAway) rays_.drop(k);
    again_[static_cast<std::size_t>(count)] = static_cast<int>(k);
    again_by_[static_cast<std::size_t>(count)] = blocker;
    const bool known = blocker != kNone && rays_.knows(mesh_.rank[static_cast<std::size_t>(blocker)]);
    count += known && (states_[k] == kLit || states_[k] == kOpen);
  }
  kernel_table().meet_pairs(
      {rays_.arrays().targets, rays_.local(), rays_.arrays().half_long, surface_.triangles->data(),
       again_.data(), again_by_.data(), blocked_.data(), apart_.data()},
      count);
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const auto k = static_cast<std::size_t>(again_[i]);
    const bool blocked = (blocked_[i / 8] >> i % 8 & 1u) != 0, apart = (apart_[i / 8] >> i % 8 & 1u) != 0;
    if (blocked || (!apart && blocking::blocks(kernel_, rays_.ray(k), surface_, again_by_[i]))) {
      hide(k, again_by_[i]);
    } else {
      blockers_[static_cast<std::size_t>(candidates_[k])] = kNone;
    }
  }
}

// The few rays without boxes, against all elements.
void FastRoute::search_aside() {
  for (const std::uint32_t k : rays_.aside) {
    if (states_[k] != kOpen) continue;
    const blocking::Ray& ray = rays_.ray(k);
    states_[k] = kLit;
    for (int e = 0; e < surface_.count && states_[k] == kLit; ++e) {
      if (e == candidates_[k] || surface_.never_blocks(e) || Box(surface_, e).apart_from_segment(ray))
        continue;
      if (blocking::blocks(kernel_, ray, surface_, e)) states_[k] = kHidden;
    }
  }
}

void FastRoute::search_tree() {
  const ElementTree tree(surface_);
  exact::Kernel kernel;
  for (std::size_t k = 0; k < candidates_.size(); ++k) {
    if (states_[k] != kOpen) continue;
    const blocking::Ray& ray = rays_.ray(k);
    kernel_.moved(ray);
    states_[k] = tree.blocked(kernel, ray, candidates_[k]) ? kHidden : kLit;
  }
  kernel_.calls += kernel.calls;
}

}  // namespace jet
