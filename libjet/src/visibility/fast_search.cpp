// SPDX-License-Identifier: Apache-2.0
// The search of the fast route: rays that meet elements facing away, then the whole rule for open rays.
#include <algorithm>

#include "visibility/box_tree.hpp"
#include "visibility/fast.hpp"
#include "visibility/sides.hpp"

namespace jet {

// Opens or hides the rays that meet an element facing away. Returns the number of rays opened without a test.
std::size_t FastRoute::open_near_away() {
  if (!facts_.bounded && !facts_.any_away) return 0;
  const std::span<const int> rays = states_.list_alive();
  if (facts_.bounded) {
    near_.for_each_touching(rays_, rays, [&](int ray, int by, Touch touch) {
      if (states_[ray] == kLit) meet_away(ray, by, touch);
    });
    return 0;
  }
  for (const int ray : rays) states_.set(ray, kOpen);
  return rays.size();
}

// Handles an element that faces away and may be on the ray. If it blocks, the ray needs no search.
void FastRoute::meet_away(int ray, int by, Touch touch) {
  const int e = mesh_->element(by);
  const bool can_block = e != mesh_->element(ray) && !surface_.never_blocks(e);
  bool hides = can_block && touch == Touch::blocked;
  if (touch == Touch::possible) {
    const blocking::Ray& segment = rays_.asked().ray(ray);
    if (!blocking::passage(view_.kernel(), segment, surface_, e).touches()) return;
    hides = can_block && blocking::blocks(view_.kernel(), segment, surface_, e);
  }
  hides ? hide(ray, by) : open(ray, by);
}

// Tests open rays against the elements that can be on them.
void FastRoute::search() {
  if (!rays_.upstream.empty()) search_upstream();
  const std::span<const int> rays = states_.list_open();
  if (rays.empty()) return;
  near_.for_each_before_target(rays_, rays, [&](int ray, int by, Touch touch) {
    const int e = mesh_->element(by);
    // The ray's own element may be among them, because the mesh's last element has several places.
    if (states_[ray] != kOpen || e == mesh_->element(ray) || surface_.never_blocks(e)) return;
    if (touch == Touch::blocked || blocking::blocks(view_.kernel(), rays_.asked().ray(ray), surface_, e))
      hide(ray, by);
  });
  for (const int ray : states_.opened())
    if (states_[ray] == kOpen) states_.settle(ray, kLit);
}

void FastRoute::hide(int ray, int by) {
  states_.set(ray, kHidden);
  hits_.add_blocker(ray, by);
}

void FastRoute::open(int ray, int by) {
  states_.set(ray, kOpen);
  hits_.add_opener(ray, by);
}

// Openers are not tested exactly: a ray opened in vain only costs a search.
void FastRoute::test_cached_blockers() {
  const auto may_block = [&](const RayHit& hit) {
    return int{states_.alive(hit.ray)} & int{rays_.knows(hit.element)};
  };
  const auto may_open = [&](const RayHit& hit) {
    return int{states_.alive(hit.ray)} & int{ShownSides::has(near_.sides().not_inner, hit.element)};
  };
  hits_.retest(
      rays_, *mesh_, may_block, may_open,
      [&](int ray, int by, bool is_certain) {
        if (is_certain ||
            blocking::blocks(view_.kernel(), rays_.asked().ray(ray), surface_, mesh_->element(by)))
          hide(ray, by);
      },
      [&](int ray, int by) {
        if (states_.alive(ray)) open(ray, by);
      });
}

// Tests the few rays without bounds against all elements.
void FastRoute::search_upstream() {
  for (const int place : rays_.upstream) {
    if (states_[place] != kOpen) continue;
    const blocking::Ray& ray = rays_.asked().ray(place);
    states_.settle(place, kLit);
    for (int e = 0; e < surface_.count && states_[place] == kLit; ++e) {
      if (e == mesh_->element(place) || surface_.never_blocks(e) || Box(surface_, e).apart_from_segment(ray))
        continue;
      if (blocking::blocks(view_.kernel(), ray, surface_, e)) states_.settle(place, kHidden);
    }
  }
}

void FastRoute::search_tree() {
  const BoxTree tree(surface_);
  for (const int place : states_.opened()) {
    if (states_[place] != kOpen) continue;
    const blocking::Ray& ray = rays_.asked().ray(place);
    const bool hidden = tree.any(ray, [&](int e) {
      return e != mesh_->element(place) && !surface_.never_blocks(e) &&
             blocking::blocks(view_.kernel(), ray, surface_, e);
    });
    states_.settle(place, hidden ? kHidden : kLit);
  }
}

}  // namespace jet
