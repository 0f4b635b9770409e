// SPDX-License-Identifier: Apache-2.0
#include "fast.hpp"

#include <cmath>
#include <numeric>

#include "tree.hpp"
#include "winding.hpp"

namespace jet {
namespace {

/// Side of an element that every source is on: 1 inner, -1 outer, 0 left open. The plane's height over the
/// line of sources is linear, so its ends decide. Roundings: 186 u size |ab| |ac| with maximum norms, u =
/// 2^-53; doubled.
int common_side(const Surface& surface, int element, const RaySource& source, double size) {
  using Map = Eigen::Map<const Eigen::Vector3d>;
  const Map a(surface.corner(element, 0)), b(surface.corner(element, 1)), c(surface.corner(element, 2));
  const double ux = b[0] - a[0], uy = b[1] - a[1], uz = b[2] - a[2];
  const double vx = c[0] - a[0], vy = c[1] - a[1], vz = c[2] - a[2];
  const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
  const Eigen::Vector3d &o = source.centre, &l = source.long_direction;
  const double height = (a[0] - o[0]) * nx + (a[1] - o[1]) * ny + (a[2] - o[2]) * nz;
  const double change = source.half_long * std::abs(l[0] * nx + l[1] * ny + l[2] * nz);
  const double error = 4e-14 * size * filter::max3(std::abs(ux), std::abs(uy), std::abs(uz)) *
                           filter::max3(std::abs(vx), std::abs(vy), std::abs(vz)) +
                       filter::kUnderflow;
  return height - change > error ? 1 : height + change < -error ? -1 : 0;
}

/// The ray crosses its own target strictly inside and outward. For an exact centroid each of the four
/// predicates that say so is o = orientation(s, a, b, c), or a third of it; the centroid's rounding moves
/// them by 16.2 u size D^2, D the largest coordinate difference, and the determinant errs by 4.7e-15 D^3, D
/// <= 2 size: 1.5e-14 size D^2 in all.
bool surely_pierces(const Surface& surface, int element, const double* s, double size) {
  const double *a = surface.corner(element, 0), *b = surface.corner(element, 1),
               *c = surface.corner(element, 2);
  const double ax = a[0] - s[0], ay = a[1] - s[1], az = a[2] - s[2];
  const double bx = b[0] - s[0], by = b[1] - s[1], bz = b[2] - s[2];
  const double cx = c[0] - s[0], cy = c[1] - s[1], cz = c[2] - s[2];
  const double value = ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
  const double largest = filter::max3(filter::max3(std::abs(ax), std::abs(ay), std::abs(az)),
                                      filter::max3(std::abs(bx), std::abs(by), std::abs(bz)),
                                      filter::max3(std::abs(cx), std::abs(cy), std::abs(cz)));
  return value > 2e-14 * size * largest * largest + filter::kUnderflow;
}

/// All sources and the element lie in one coordinate plane: every orientation is 0, without any arithmetic.
bool in_one_coordinate_plane(const Surface& surface, int element, const RaySource& source) {
  for (int i = 0; i < 3; ++i) {
    const double x = source.centre[i];
    const bool flat_source = source.half_long == 0.0 || source.long_direction[i] == 0.0;
    if (flat_source && surface.corner(element, 0)[i] == x && surface.corner(element, 1)[i] == x &&
        surface.corner(element, 2)[i] == x) {
      return true;
    }
  }
  return false;
}

bool box_holds(const Surface& surface, int element, const double* s) {
  const double *a = surface.corner(element, 0), *b = surface.corner(element, 1),
               *c = surface.corner(element, 2);
  for (int i = 0; i < 3; ++i) {
    if (s[i] < std::min({a[i], b[i], c[i]}) || s[i] > std::max({a[i], b[i], c[i]})) return false;
  }
  return true;
}

}  // namespace

void FastRoute::prepare(std::size_t element_count, std::size_t node_count, bool closed) {
  closed_ = closed;
  bundle_.reserve(element_count);
  grid_.reserve(element_count);
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
  has_grid_ = false;
  if (counters.fallbacks > 0 || !away_.empty()) {
    has_grid_ = bundle_.funnel.bounded && grid_.build(bundle_.rays, source, size);
    if (certain) open_near_away(surface);
    resolve(surface, source, candidates);
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

// Elements that a ray can meet, by the sides on which their corners lie outside.
void FastRoute::collect(const Surface& surface) {
  near_.clear();
  on_way_.clear();
  if (!bundle_.funnel.bounded) {
    near_.resize(static_cast<std::size_t>(surface.count));
    std::iota(near_.begin(), near_.end(), 0);
    return;
  }
  for (int i = 0; i < surface.node_count; ++i) {
    codes_[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(bundle_.funnel.code(surface.node(i)));
  }
  for (int e = 0; e < surface.count; ++e) {
    const auto& t = surface.triangles[e];
    const unsigned common = codes_[static_cast<std::size_t>(t[0])] & codes_[static_cast<std::size_t>(t[1])] &
                            codes_[static_cast<std::size_t>(t[2])];
    if ((common & Funnel::kOutside) != 0) continue;
    near_.push_back(e);
    if (common == 0) on_way_.push_back(e);
  }
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
  if (!flat && source.half_long > 0.0) {
    suspects_.push_back(element);
    away_.push_back(element);
    shared_ = shared_ && same_side(surface, element);
    return;
  }
  int side = flat ? 0 : kernel_.orientation(source.centre.data(), a, b, c);
  if (side == 0) {
    suspects_.push_back(element);
    side = -kernel_.slope(source.axis.data(), a, b, c);
    shared_ = shared_ && (side != 0 || source.half_long == 0.0);
  }
  if (side < 0) away_.push_back(element);
}

// No way from one source to another crosses the element: it is beside all of them, or they are on one side of
// it.
bool FastRoute::same_side(const Surface& surface, int element) {
  double low[3], high[3];
  for (int i = 0; i < 3; ++i) {
    low[i] = HUGE_VAL, high[i] = -HUGE_VAL;
    for (const auto& ray : bundle_.rays)
      low[i] = std::min(low[i], ray.source[i]), high[i] = std::max(high[i], ray.source[i]);
  }
  const double *a = surface.corner(element, 0), *b = surface.corner(element, 1),
               *c = surface.corner(element, 2);
  for (int i = 0; i < 3; ++i) {
    if (high[i] < std::min({a[i], b[i], c[i]}) || low[i] > std::max({a[i], b[i], c[i]})) return true;
  }
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
  if (bundle_.funnel.bounded) {
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

// Rays for which the argument of fast.hpp does not hold for certain are open; their number is returned. Predicates that
// are not zero stay as they are if the source is moved, so here they are taken without.
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
  return open;
}

void FastRoute::open_near_away(const Surface& surface) {
  if (away_.empty()) return;
  if (!has_grid_) {
    std::replace(states_.begin(), states_.end(), kLit, kOpen);
    return;
  }
  for (const int e : away_) {
    grid_.for_each_near(surface, e, [&](std::uint32_t k) {
      if (states_[k] == kLit && blocking::passage(kernel_, bundle_.rays[k], surface, e).touches())
        states_[k] = kOpen;
    });
  }
}

bool FastRoute::source_on_suspect(const Surface& surface, const blocking::Ray& ray) {
  for (const int e : suspects_) {
    if (box_holds(surface, e, ray.source) && blocking::source_on(kernel_, ray, surface, e)) return true;
  }
  return false;
}

// The whole rule for the open rays.
void FastRoute::resolve(const Surface& surface, const RaySource& source, std::span<const int> candidates) {
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
  if (any) search(surface, candidates);
}

void FastRoute::search(const Surface& surface, std::span<const int> candidates) {
  if (has_grid_) {
    for (const int e : near_) {
      if (surface.never_blocks(e)) continue;
      grid_.for_each_near(surface, e, [&](std::uint32_t k) {
        const bool asked = states_[k] == kOpen && e != candidates[k];
        if (asked && blocking::blocks(kernel_, bundle_.rays[k], surface, e)) states_[k] = kHidden;
      });
    }
    for (State& state : states_) state = state == kOpen ? kLit : state;
    return;
  }
  const ElementTree tree(surface);
  exact::Kernel kernel;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    if (states_[k] == kOpen)
      states_[k] = tree.blocked(kernel, bundle_.rays[k], candidates[k]) ? kHidden : kLit;
  }
  kernel_.calls += kernel.calls;
}

}  // namespace jet
