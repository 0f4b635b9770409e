// SPDX-License-Identifier: Apache-2.0
#include "skin_looks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coupling::detail {
namespace {

constexpr double kMeet = 1e-9;         // share of the thickness: closer parts have met
constexpr double kStart = 1.0 + 1e-6;  // of the reach: parts that start a rounding apart from it start at it

}  // namespace

void SkinLooks::advance() {
  ++level;
  touches.clear();
  approach = 0.0;
}

double SkinLooks::look(const SkinParts& parts, const SkinLimits& limits, const PartPair& pair, double most,
                       const Nodes& before, const Nodes& now) {
  const double reach = limits.reach_of(pair), meet = kMeet * parts.parameters.thickness;
  const Corners corners = corners_of(parts, pair);
  const Quad x = positions(corners, now);
  const Closest closest = closest_of(pair.edges, x);
  ++looks;
  if (!(closest.distance > meet)) throw_gap(parts, pair, 0.0);
  if (level == 0) {
    if (closest.distance < kStart * reach) touches.push_back({pair, closest, closest.distance});
    return closest.distance;
  }
  const Quad y = positions(corners, before);
  if (!(most < closest.distance) && !(relative_motion(pair.edges, y, x) < closest.distance)) {
    ++sweeps;
    if (paths_meet(pair.edges, y, x, meet)) throw_gap(parts, pair, relative_motion(pair.edges, y, x));
  }
  // Of the closest points, as they move on.
  const Eigen::Vector3d step = (x - y) * closest.weight;
  const double closing = -closest.normal.dot(step), ahead = closest.distance - kAhead * closing;
  bool touch = closest.distance < reach;
  if (closing > 0.0 && ahead < reach) {
    const double nearest = std::min(kAhead, closest.distance * closing / step.squaredNorm());
    if ((closest.distance * closest.normal + nearest * step).norm() < reach) {
      touch = true;
      approach = std::max(approach, closing / parts.reach_of(pair.edges));
    }
  }
  if (touch) touches.push_back({pair, closest, ahead});
  return closest.distance;
}

void SkinLooks::look_at_all(const SkinParts& parts, const SkinLimits& limits, const Nodes& before,
                            const Nodes& now) {
  const auto consider = [&](const PartPair& pair) {
    if (!parts.neighbours(pair))
      look(parts, limits, pair, std::numeric_limits<double>::infinity(), before, now);
  };
  const auto consider_nodes = [&](int of_nodes, int of_elements) {
    for (const int e : parts.group_elements(of_elements))
      for (const int n : parts.group_nodes[of_nodes]) consider({n, e, false});
  };
  const auto groups = static_cast<int>(parts.groups.count());
  for (int first = 0; first < groups; ++first)
    for (int second = first; second < groups; ++second) {
      consider_nodes(first, second);
      if (first != second) consider_nodes(second, first);
      const auto a = parts.group_edges[first], b = parts.group_edges[second];
      for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = first == second ? i + 1 : 0; k < b.size(); ++k) consider({a[i], b[k], true});
    }
}

}  // namespace coupling::detail
