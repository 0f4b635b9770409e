// SPDX-License-Identifier: Apache-2.0
#include "skin_looks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coupling::detail {
namespace {

constexpr double kMeet = 1e-9;  // share of the thickness: closer parts have met

}  // namespace

SkinLooks::SkinLooks(const SkinParts& parts)
    : paths(parts), far_(2.0 * (parts.parameters.thickness + parts.mean_edge)) {}

void SkinLooks::advance(const Nodes& nodes) {
  ++level;
  touches.clear();
  approach = 0.0;
  paths.advance(nodes);
}

// One pair of parts: their distance [m].
double SkinLooks::look(const SkinParts& parts, const PartPair& pair) {
  const double reach = parts.reach_of(pair.edges), meet = kMeet * parts.parameters.thickness;
  const Corners corners = corners_of(parts, pair);
  const Quad x = positions(corners, paths.now());
  const Closest closest = closest_of(pair.edges, x);
  ++looks;
  if (!(closest.distance > meet)) throw_gap(parts, pair, 0.0);
  if (level == 0) {
    if (closest.distance < reach) touches.push_back({pair, closest, closest.distance});
    return closest.distance;
  }
  const Quad y = positions(corners, paths.before());
  const double motion = relative_motion(pair.edges, y, x);
  if (!(motion < closest.distance)) {
    ++sweeps;
    if (paths_meet(pair.edges, y, x, meet)) throw_gap(parts, pair, motion);
  }
  const double closing = -closest.normal.dot((x - y) * closest.weight);
  const double ahead = closest.distance - kAhead * closing;
  if (ahead < reach) approach = std::max(approach, closing / reach);
  if (closest.distance < reach) touches.push_back({pair, closest, ahead});
  return closest.distance;
}

double SkinLooks::least_distance(const SkinParts& parts, SkinBoxes& boxes, int first, int second,
                                 double ahead) {
  // What may touch ahead tells how fast it closes.
  const double near =
      &boxes == &paths ? parts.parameters.thickness + ahead : -std::numeric_limits<double>::infinity();
  const float apart = gap(boxes.whole(parts, first), boxes.whole(parts, second));
  const double rounding = boxes.rounding();
  if (apart > std::max(near + rounding, 0.5 * far_)) return apart - rounding;
  const std::uint64_t* mask = parts.masks.of(first, second);
  const GroupBoxes &a = boxes.of(parts, first), &b = boxes.of(parts, second);
  double least = far_;
  const auto search = [&](const PartBoxes& rows, const PartBoxes& lanes, const Box& whole, auto&& pair_of) {
    found_.clear();
    least = std::min<double>(least, least_gap({rows, lanes, whole, mask}, static_cast<float>(near + rounding),
                                              static_cast<float>(least), found_));
    for (const auto [row, lane] : found_) least = std::min(least, look(parts, pair_of(row, lane)));
    if (mask) mask += rows.count;
  };
  const auto search_nodes = [&](const GroupBoxes& nodes, int of_nodes, const GroupBoxes& elements,
                                int of_elements) {
    search(elements.elements, nodes.nodes, nodes.whole, [&](std::size_t row, std::size_t lane) {
      return PartPair{parts.group_nodes[of_nodes][lane], parts.group_elements(of_elements)[row], false};
    });
  };
  search_nodes(a, first, b, second);
  if (first != second) search_nodes(b, second, a, first);
  search(a.edges, b.edges, b.whole, [&](std::size_t row, std::size_t lane) {
    return PartPair{parts.group_edges[first][row], parts.group_edges[second][lane], true};
  });
  return least - rounding;
}

void SkinLooks::look_at_all(const SkinParts& parts) {
  const auto consider = [&](const PartPair& pair) {
    if (!parts.neighbours(pair)) look(parts, pair);
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
