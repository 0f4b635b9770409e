// SPDX-License-Identifier: Apache-2.0
#include "rays.hpp"

#include <cmath>

#include "sides.hpp"

namespace jet {
namespace {

constexpr double kMargin = 1e-11;         // relative to the coordinates' size: 1e5 roundings
constexpr double kSteepest = 1e6;         // slope against the axis, which widens the margins
constexpr std::size_t kMostAside = 64;    // more of them are quicker in a tree
constexpr Pair kWaySlope{0.137, -0.291};  // a general direction: bags are symmetric about the axis

Pair lower(Pair a, Pair b) {
  return a < b ? a : b;
}
Pair higher(Pair a, Pair b) {
  return a > b ? a : b;
}
Pair magnitude(Pair a) {
  return higher(a, -a);
}

}  // namespace

void RayBundle::reserve(std::size_t count) {
  rays.reserve(count);
  aside.reserve(kMostAside);
}

void RayBundle::build(const Surface& surface, const RaySource& source, std::span<const int> candidates,
                      double size) {
  rays.resize(candidates.size());
  for (std::size_t k = 0; k < rays.size(); ++k) rays[k] = blocking::make_ray(surface, candidates[k], source);
  low_source_ = Eigen::Array3d::Constant(HUGE_VAL);
  high_source_ = -low_source_;
  for (const blocking::Ray& ray : rays) {
    const Eigen::Map<const Eigen::Array3d> s(ray.source);
    low_source_ = low_source_.min(s);
    high_source_ = high_source_.max(s);
  }
  margin_ = kMargin * size;
  aside.clear();
  bounded = frame.build(source) && bound_slopes();
  if (!bounded) return;
  bound(source);
  set_way(size);
}

// The steepest slopes of the rays; false if too many have to be left aside.
bool RayBundle::bound_slopes() {
  funnel.slope_low = Pair{kSteepest, kSteepest};
  funnel.slope_high = -funnel.slope_low;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const Local d = frame.direction(rays[k].source, rays[k].target);
    if (d.w * kSteepest > std::abs(d.side[0]) + std::abs(d.side[1])) {
      const Pair slope = d.side / d.w;
      funnel.slope_low = lower(funnel.slope_low, slope);
      funnel.slope_high = higher(funnel.slope_high, slope);
    } else if (aside.size() < kMostAside) {
      aside.push_back(static_cast<std::uint32_t>(k));
    } else {
      aside.clear();
      return false;
    }
  }
  return true;
}

// All sources lie between the two ends of the outlet: the bounds hold there, so they hold in between.
void RayBundle::bound(const RaySource& source) {
  const Pair margin = margin_ * (1.0 + magnitude(funnel.slope_low) + magnitude(funnel.slope_high));
  funnel.low_w = HUGE_VAL;
  funnel.low = Pair{HUGE_VAL, HUGE_VAL};
  funnel.high = -funnel.low;
  for (const double t : {-source.half_long, source.half_long}) {
    const Eigen::Vector3d end =
        t == 0.0 ? source.centre : Eigen::Vector3d(source.centre + t * source.long_direction);
    const Local at = frame.at(end.data());
    funnel.low_w = std::min(funnel.low_w, at.w - margin_);
    funnel.low = lower(funnel.low, at.side - funnel.slope_low * at.w - margin);
    funnel.high = higher(funnel.high, at.side - funnel.slope_high * at.w + margin);
  }
}

void RayBundle::set_way(double size) {
  way_ray = rays[0];
  way_ray.moved = true;
  const double reach = 4.0 * size;  // at least 2.3 size along one coordinate, so that the end is outside
  for (int i = 0; i < 3; ++i) {
    way_ray.target[i] = way_ray.source[i] + reach * (frame.forward[i] + kWaySlope[0] * frame.across[i] +
                                                     kWaySlope[1] * frame.along[i]);
  }
  const Local from = frame.at(way_ray.source);
  funnel.way_slope = kWaySlope;
  funnel.way_offset = from.side - kWaySlope * from.w;
  funnel.way_margin = margin_ * (1.0 + magnitude(kWaySlope));
}

bool RayBundle::beside_sources(const Surface& surface, int element) const {
  const Box box(surface, element);
  for (int i = 0; i < 3; ++i) {
    if (box.high[i] < low_source_[i] || box.low[i] > high_source_[i]) return true;
  }
  if (!bounded || !frame.line) return false;
  unsigned sides = 0xf;  // of the line, on which all corners are
  for (int i = 0; i < 3; ++i) {
    const Local x = frame.at(surface.corner(element, i));
    sides &= (x.w > margin_ ? 1u : 0u) | (x.w < -margin_ ? 2u : 0u) | (x.side[0] > margin_ ? 4u : 0u) |
             (x.side[0] < -margin_ ? 8u : 0u);
  }
  return sides != 0;
}

}  // namespace jet
