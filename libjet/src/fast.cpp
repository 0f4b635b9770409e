// SPDX-License-Identifier: Apache-2.0
#include "fast.hpp"

#include <cmath>
#include <numeric>

#include "sides.hpp"
#include "tree.hpp"
#include "winding.hpp"

namespace jet {
void FastRoute::prepare(std::size_t element_count, std::size_t node_count, bool closed) {
  closed_ = closed;
  bundle_.reserve(element_count);
  grid_.reserve(element_count, node_count);
  codes_.resize(node_count);
  for (std::vector<int>* list : {&near_, &on_way_, &away_, &suspects_}) list->reserve(element_count);
  states_.reserve(element_count);
}

VisibilityCounters FastRoute::query(const Surface& surface, const RaySource& source, double size,
                                    std::span<const int> candidates, std::span<std::uint8_t> lit) {
  kernel_.calls = 0;
  bundle_.build(surface, source, candidates, size);
  collect(surface);
  classify(surface, source, size);
  const bool certain = closed_ && shared_ && winding_is_one(surface);
  VisibilityCounters counters;
  counters.fallbacks = open_uncertain(surface, candidates, size, certain);
  if (counters.fallbacks > 0 || !away_.empty()) {
    if (bundle_.bounded) grid_.build(bundle_, surface, size);
    if (certain) counters.fallbacks += open_near_away(surface);
    if (resolve(surface, source, candidates)) {
      counters.tree_builds = bundle_.bounded ? 0 : 1;
      bundle_.bounded ? search(surface, candidates) : search_tree(surface, candidates);
    }
  }
  counters.candidates = candidates.size();
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    lit[k] = states_[k] == kLit;
    counters.lit += states_[k] == kLit;
    counters.hidden += states_[k] == kHidden;
    counters.facing_away += states_[k] == kFacingAway;
  }
  counters.exact_calls = kernel_.calls;
  return counters;
}

// Elements that a ray not aside or the way can meet, by the sides on which their corners lie outside.
void FastRoute::collect(const Surface& surface) {
  near_.clear();
  on_way_.clear();
  if (!bundle_.bounded) {
    near_.resize(static_cast<std::size_t>(surface.count));
    std::iota(near_.begin(), near_.end(), 0);
    return;
  }
  std::uint16_t* codes = codes_.data();
  const Frame frame = bundle_.frame;
  const Funnel funnel = bundle_.funnel;
  for (int i = 0; i < surface.node_count; ++i)
    codes[i] = static_cast<std::uint16_t>(funnel.code(frame.at(surface.node(i))));
  near_.resize(static_cast<std::size_t>(surface.count));
  int* near = near_.data();
  std::size_t count = 0;
  for (int e = 0; e < surface.count; ++e) {
    const auto& t = surface.triangles[e];
    const unsigned common = static_cast<unsigned>(codes[t[0]] & codes[t[1]] & codes[t[2]]);
    near[count] = e;  // kept if the next does not overwrite it: no branch to predict
    count += (common & Funnel::kOutside) == 0;
    if ((common & Funnel::kOffWay) == 0) on_way_.push_back(e);
  }
  near_.resize(count);
}

void FastRoute::classify(const Surface& surface, const RaySource& source, double size) {
  away_.clear();
  suspects_.clear();
  shared_ = true;
  for (const int e : near_) {
    const int side = common_side(surface, e, source, size);
    if (side > 0) continue;
    if (side < 0) {
      away_.push_back(e);
    } else {
      classify_suspect(surface, source, e);
    }
  }
}

// The sources' sides of an element that rounding, or the outlet's length, left open.
void FastRoute::classify_suspect(const Surface& surface, const RaySource& source, int element) {
  const double *a = surface.corner(element, 0), *b = surface.corner(element, 1),
               *c = surface.corner(element, 2);
  const bool flat = in_one_coordinate_plane(surface, element, source);
  const bool beside = bundle_.beside_sources(surface, element);
  if (!flat && source.half_long > 0.0) {
    away_.push_back(element);
    if (beside) return;
    suspects_.push_back(element);
    shared_ = shared_ && same_side(surface, element);
    return;
  }
  int side = flat ? 0 : kernel_.orientation(source.centre.data(), a, b, c);
  if (side == 0) {
    if (!beside) suspects_.push_back(element);
    side = -kernel_.slope(source.axis.data(), a, b, c);
    shared_ = shared_ && (side != 0 || source.half_long == 0.0);
  }
  if (side < 0) away_.push_back(element);
}

// No way from one source to another crosses the element's plane.
bool FastRoute::same_side(const Surface& surface, int element) {
  int common = 0;
  for (blocking::Ray ray : bundle_.rays) {
    ray.moved = true;
    const int side = blocking::facing(kernel_, ray, surface, element);
    if (side == 0 || side == -common) return false;
    common = side;
  }
  return true;
}

bool FastRoute::winding_is_one(const Surface& surface) {
  if (bundle_.bounded) {
    int sum = 0;
    bool generic = true;
    for (const int e : on_way_) {
      const std::optional<int> part = winding::crossing(kernel_, bundle_.way_ray, surface, e);
      generic = generic && part.has_value();
      sum += part.value_or(0);
    }
    if (generic) return sum == 1;
  }
  blocking::Ray from = bundle_.rays[0];
  from.moved = true;
  return winding::number(kernel_, from, surface, winding::bounding_box(surface)) == 1;
}

// Rays for which the argument of fast.hpp does not hold for certain are open; their number is returned.
// Predicates that are not zero stay as they are if the source is moved, so here they are taken without.
std::size_t FastRoute::open_uncertain(const Surface& surface, std::span<const int> candidates, double size,
                                      bool certain) {
  states_.assign(candidates.size(), kLit);
  std::size_t open = 0;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const blocking::Ray& ray = bundle_.rays[k];
    if (certain && surely_pierces(surface, candidates[k], ray.source, size)) continue;
    const int side = blocking::facing(kernel_, ray, surface, candidates[k]);
    const bool short_cut =
        certain && side > 0 && blocking::passage(kernel_, ray, surface, candidates[k]).pierces();
    states_[k] = side < 0 ? kFacingAway : short_cut ? kLit : kOpen;
    open += states_[k] == kOpen;
  }
  for (const std::uint32_t k : bundle_.aside) {  // elements outside the funnel were not looked at
    if (states_[k] != kLit) continue;
    states_[k] = kOpen;
    ++open;
  }
  return open;
}

// Rays that meet an element facing away. Returns the number of those opened without being looked at.
std::size_t FastRoute::open_near_away(const Surface& surface) {
  if (away_.empty()) return 0;
  if (!bundle_.bounded) {
    const auto unseen = std::count(states_.begin(), states_.end(), kLit);
    std::replace(states_.begin(), states_.end(), kLit, kOpen);
    return static_cast<std::size_t>(unseen);
  }
  for (const int e : away_) {
    const Box box(surface, e);
    grid_.for_each_near(surface, e, [&](std::uint32_t k) {
      if (states_[k] == kLit && !box.apart_from_ray(bundle_.rays[k]) &&
          blocking::passage(kernel_, bundle_.rays[k], surface, e).touches())
        states_[k] = kOpen;
    });
  }
  return 0;
}

bool FastRoute::source_on_suspect(const Surface& surface, const blocking::Ray& ray) {
  for (const int e : suspects_) {
    if (Box(surface, e).holds(ray.source) && blocking::source_on(kernel_, ray, surface, e)) return true;
  }
  return false;
}

// The whole rule for the open rays begins with their facing. True if any is left to be searched for blockers.
bool FastRoute::resolve(const Surface& surface, const RaySource& source, std::span<const int> candidates) {
  bool any = false, known = false, moved = false;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    if (states_[k] != kOpen) continue;
    blocking::Ray& ray = bundle_.rays[k];
    if (!known) moved = source_on_suspect(surface, ray);
    known = source.half_long == 0.0;
    ray.moved = moved;
    const bool faces = blocking::facing(kernel_, ray, surface, candidates[k]) > 0;
    if (!faces) states_[k] = kFacingAway;
    any = any || faces;
  }
  return any;
}

void FastRoute::search(const Surface& surface, std::span<const int> candidates) {
  for (const int e : near_) {
    if (surface.never_blocks(e)) continue;
    const Box box(surface, e);
    grid_.for_each_near(surface, e, [&](std::uint32_t k) {
      const bool asked =
          states_[k] == kOpen && e != candidates[k] && !box.apart_from_segment(bundle_.rays[k]);
      if (asked && blocking::blocks(kernel_, bundle_.rays[k], surface, e)) states_[k] = kHidden;
    });
  }
  if (!bundle_.aside.empty()) search_aside(surface, candidates);
  std::replace(states_.begin(), states_.end(), kOpen, kLit);
}

// The few rays outside the funnel, against all elements.
void FastRoute::search_aside(const Surface& surface, std::span<const int> candidates) {
  for (int e = 0; e < surface.count; ++e) {
    if (surface.never_blocks(e)) continue;
    const Box box(surface, e);
    for (const std::uint32_t k : bundle_.aside) {
      if (states_[k] != kOpen || e == candidates[k] || box.apart_from_segment(bundle_.rays[k])) continue;
      if (blocking::blocks(kernel_, bundle_.rays[k], surface, e)) states_[k] = kHidden;
    }
  }
}

void FastRoute::search_tree(const Surface& surface, std::span<const int> candidates) {
  const ElementTree tree(surface);
  exact::Kernel kernel;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    if (states_[k] != kOpen) continue;
    states_[k] = tree.blocked(kernel, bundle_.rays[k], candidates[k]) ? kHidden : kLit;
  }
  kernel_.calls += kernel.calls;
}

}  // namespace jet
