// SPDX-License-Identifier: Apache-2.0
#include "visibility/both_ways.hpp"

#include <algorithm>
#include <cmath>

namespace jet {
namespace {

constexpr double kSquare = 1e-5;  // share of the largest depth; larger than the error of the projection

}  // namespace

void BothWays::prepare(std::shared_ptr<const OrderedMesh> mesh, std::size_t node_count, bool closed) {
  mesh_ = std::move(mesh);
  node_count_ = node_count;
  closed_ = closed;
  downstream_.prepare(mesh_, node_count_, closed_, Way::downstream);
}

void BothWays::move_to(double displacement_bound) {
  downstream_.move_to(displacement_bound);
  if (upstream_) upstream_->move_to(displacement_bound);
}

VisibilityCounters BothWays::query(const Surface& surface, const RaySource& source,
                                   std::span<const int> candidates, std::span<std::uint8_t> lit) {
  if (downstream_.begin(surface, source, candidates)) return downstream_.answer(lit);
  split(surface, source, candidates);
  if (parts_[1].elements.empty()) return downstream_.answer(lit);
  VisibilityCounters sum;
  for (Part& part : parts_) {
    if (part.elements.empty()) continue;
    FastRoute& route = &part == parts_ ? downstream_ : upstream_route();
    route.begin(surface, source, part.elements);
    part.lit.resize(part.elements.size());
    sum += route.answer(part.lit);
    for (std::size_t k = 0; k < part.lit.size(); ++k) lit[part.places[k]] = part.lit[k];
  }
  return sum;
}

// Rays nearly perpendicular to the axis have no bounds in either direction. They stay with the downstream
// rays.
void BothWays::split(const Surface& surface, const RaySource& source, std::span<const int> candidates) {
  for (Part& part : parts_) {
    part.elements.clear();
    part.places.clear();
  }
  depths_.clear();
  double largest = 0.0;
  for (const int e : candidates) {
    const blocking::Ray ray = blocking::make_ray(surface, e, source);
    double depth = 0.0;
    for (int i = 0; i < 3; ++i) depth += (ray.target[i] - ray.source[i]) * source.axis[i];
    depths_.push_back(depth);
    largest = std::max(largest, std::abs(depth));
  }
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    Part& part = parts_[depths_[k] < -kSquare * largest ? 1 : 0];
    part.elements.push_back(candidates[k]);
    part.places.push_back(k);
  }
}

FastRoute& BothWays::upstream_route() {
  if (!upstream_) {
    upstream_ = std::make_unique<FastRoute>();
    upstream_->prepare(mesh_, node_count_, closed_, Way::upstream);
  }
  return *upstream_;
}

}  // namespace jet
