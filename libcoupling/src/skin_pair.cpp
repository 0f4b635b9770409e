// SPDX-License-Identifier: Apache-2.0
#include "skin_pair.hpp"

#include <algorithm>
#include <cmath>

#include "check.hpp"

namespace coupling::detail {

Corners corners_of(const SkinParts& parts, const PartPair& pair) {
  const auto second = static_cast<std::size_t>(pair.second);
  if (pair.edges) {
    const auto &a = parts.edges[static_cast<std::size_t>(pair.first)], &b = parts.edges[second];
    return {{a[0], a[1], b[0], b[1]}, true};
  }
  const auto corner = parts.triangles.col(pair.second);
  return {{pair.first, corner[0], corner[1], corner[2]}, false};
}

Quad positions(const Corners& corners, const Nodes& nodes) {
  Quad x;
  for (int k = 0; k < 4; ++k) x.col(k) = nodes.col(corners.node[k]);
  return x;
}

Closest closest_of(bool edges, const Quad& x) {
  Closest closest{};
  if (edges) {
    const auto [s, t] = closest_of_segments(x.col(0), x.col(1) - x.col(0), x.col(2), x.col(3) - x.col(2));
    closest.weight = {1.0 - s, s, t - 1.0, -t};
  } else {
    const TrianglePoint at = closest_on_triangle(x.col(0), x.col(1), x.col(2), x.col(3));
    closest.weight = {1.0, -at.weight[0], -at.weight[1], -at.weight[2]};
  }
  // Of differences, so that a shift of all corners changes little.
  const int split = edges ? 2 : 1;
  Eigen::Vector3d apart = Eigen::Vector3d::Zero();
  for (int k = 0; k < 4; ++k)
    if (k != split) apart += closest.weight[k] * (x.col(k) - x.col(split));
  closest.distance = apart.norm();
  closest.normal = apart / closest.distance;
  return closest;
}

double relative_motion(bool edges, const Quad& from, const Quad& to) {
  const Quad motion = to - from;
  const int split = edges ? 2 : 1;
  double largest = 0.0;
  for (int i = 0; i < split; ++i)
    for (int j = split; j < 4; ++j)
      largest = std::max(largest, (motion.col(i) - motion.col(j)).squaredNorm());
  return std::sqrt(largest);
}

bool paths_meet(bool edges, const Quad& from, const Quad& to, double tolerance) {
  const double motion = relative_motion(edges, from, to);
  constexpr double least = 1e-6;  // share of the step: with smaller advances rounding would stop the time
  for (double t = 0.0;;) {
    const double distance = closest_of(edges, from + t * (to - from)).distance;
    // The last advance must not jump over the meeting.
    if (!(distance > std::max(tolerance, least * motion))) return true;
    t += std::max(least, distance / motion);
    if (!(t < 1.0)) return false;
  }
}

SkinPair named(const SkinParts& parts, const PartPair& pair, double gap) {
  const Corners corners = corners_of(parts, pair);
  SkinPair named;
  named.gap = gap;
  const int split = corners.split();
  for (int k = 0; k < split; ++k) named.first[k] = corners.node[k];
  for (int k = split; k < 4; ++k) named.second[k - split] = corners.node[k];
  return named;
}

void throw_gap(const SkinParts& parts, const PartPair& pair, double motion) {
  const double reach = parts.reach_of(pair.edges);
  throw GapError("self-contact: " + text_of(named(parts, pair, 0.0)) + " met; they moved " + text(motion, 3) +
                     " m relative to each other within the step, and touch within " + text(reach, 3) + " m",
                 named(parts, pair, 0.0), motion);
}

}  // namespace coupling::detail
