// SPDX-License-Identifier: Apache-2.0
#include "visibility/fast.hpp"

#include <algorithm>

#include "visibility/sides.hpp"
#include "visibility/winding.hpp"

namespace jet {
namespace {

constexpr std::size_t kFewUpstream = 4;  // each costs as much as two passes over the surface

}  // namespace

void FastRoute::prepare(std::shared_ptr<const OrderedMesh> mesh, std::size_t node_count, bool closed,
                        Way way) {
  closed_ = closed;
  mesh_ = std::move(mesh);
  near_.reserve(*mesh_);
  rays_.reserve(*mesh_, node_count, way);
  states_.reserve(rays_.asked().bits().size());
  hits_.reserve(rays_.asked().bits().size());
}

bool FastRoute::begin(const Surface& surface, const RaySource& source, std::span<const int> candidates) {
  surface_ = surface;
  view_.begin(surface, source);
  rays_.ask(surface, source, candidates);
  states_.reset(rays_.asked().bits());
  const auto found_near = [&] {
    near_.find(rays_);
    return rays_.accept(near_.found(), near_.patches(), near_.upstream());
  };
  facts_.bounded = (rays_.project_chosen() && found_near()) || (rays_.project_fresh() && found_near());
  return rays_.upstream.size() <= kFewUpstream;
}

VisibilityCounters FastRoute::answer(std::span<std::uint8_t> lit) {
  if (!facts_.bounded) rays_.do_without();
  facts_.bounded ? classify_near() : classify_all();
  const bool certain = closed_ && facts_.shared && winding_is_one();
  std::size_t fallbacks = open_uncertain(certain), trees = 0;
  if (facts_.bounded) test_cached_blockers();
  if (certain) fallbacks += open_near_away();
  if (facts_.bounded) {
    search();
  } else if (!states_.opened().empty()) {
    search_tree();
    trees = 1;
  }
  VisibilityCounters counters = states_.count(rays_.asked().places(), lit);
  counters.exact_calls = view_.kernel().calls;
  counters.fallbacks = fallbacks;
  counters.tree_builds = trees;
  return counters;
}

// Rules out near elements of uncertain side that do face all sources.
void FastRoute::classify_near() {
  facts_.shared = true;
  for (const int place : near_.uncertain())
    if (!view_.may_face_away(mesh_->element(place), rays_.projection().size))
      near_.sides().rule_out_outer(place);
  for (const int place : near_.between())
    facts_.shared = facts_.shared && !view_.between_sources(mesh_->element(place), rays_);
}

void FastRoute::classify_all() {
  facts_.any_away = false;
  facts_.shared = true;
  for (int place = 0; place < surface_.count; ++place) {
    facts_.any_away = facts_.any_away || view_.may_face_away(mesh_->element(place), rays_.projection().size);
    facts_.shared = facts_.shared && !view_.between_sources(mesh_->element(place), rays_);
  }
}

bool FastRoute::winding_is_one() {
  if (facts_.bounded) {
    int sum = 0;
    bool generic = true;
    for (const int place : near_.on_winding_ray()) {
      const auto part =
          winding::crossing(view_.kernel(), rays_.winding().ray, surface_, mesh_->element(place));
      generic = generic && part.has_value();
      sum += part.value_or(0);
    }
    if (generic) return sum == 1;
  }
  blocking::Ray from = rays_.asked().ray(rays_.asked().places().front());
  from.moved = blocking::Moved::yes;
  return winding::number(view_.kernel(), from, surface_, winding::bounding_box(surface_)) == 1;
}

// Opens the rays for which the argument of fast.hpp is not certain. Returns the number of rays that may still
// be lit.
std::size_t FastRoute::open_uncertain(bool certain) {
  const auto rays =
      certain && facts_.bounded ? states_.list_alive(near_.sides().inner) : states_.list_alive();
  for (const int place : rays) {
    const int e = mesh_->element(place);
    const blocking::Ray& ray = rays_.asked().ray(place);
    if (blocking::facing(view_.kernel(), ray, surface_, e) <= 0) {
      states_.set(place, kFacingAway);
    } else if (!certain || !blocking::passage(view_.kernel(), ray, surface_, e).pierces()) {
      states_.set(place, kOpen);
    }
  }
  for (const int place : rays_.upstream)  // elements beside the other rays were not examined
    if (states_[place] == kLit) states_.set(place, kOpen);
  return states_.opened().size();
}

}  // namespace jet
