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
  rays_.for_each_touching(boxes_, points_.data(), away_, hits_.data(),
                          [&](int hit, int slot) { meet_away(hit, near_[static_cast<std::size_t>(slot)]); });
  return 0;
}

// One ray and one element that faces away and may be on it. If it is, and blocks, the ray need not be
// searched.
void FastRoute::meet_away(int hit, int element) {
  const auto k = static_cast<std::size_t>(hit / kHitKinds);
  if (states_[k] != kLit && states_[k] != kOpen) return;
  const int kind = hit % kHitKinds;
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
  const int count = rays_.touching_elements(boxes_, points_.data(), k, hits_.data());
  for (int i = 0; i < count; ++i) {
    const int hit = hits_[static_cast<std::size_t>(i)], e = near_[static_cast<std::size_t>(hit / kHitKinds)];
    if (e == candidates_[k] || surface_.never_blocks(e)) continue;
    if (hit % kHitKinds == kBlocked || blocking::blocks(kernel_, rays_.ray(k), surface_, e)) {
      hide(k, e);
      return;
    }
  }
  states_[k] = kLit;
}

void FastRoute::hide(std::size_t k, int blocker) {
  states_[k] = kHidden;
  blockers_[static_cast<std::size_t>(candidates_[k])] = blocker;
  rays_.boxes.drop(static_cast<int>(k));
}

// What blocked an element's ray at the last query often does so again.
void FastRoute::hide_again() {
  for (std::size_t k = 0; k < candidates_.size(); ++k) {
    int& blocker = blockers_[static_cast<std::size_t>(candidates_[k])];
    if (states_[k] == kFacingAway) rays_.boxes.drop(static_cast<int>(k));
    if (blocker == kNone || (states_[k] != kLit && states_[k] != kOpen)) continue;
    if (blocking::blocks(kernel_, rays_.ray(k), surface_, blocker)) {
      hide(k, blocker);
    } else {
      blocker = kNone;
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
