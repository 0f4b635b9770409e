// SPDX-License-Identifier: Apache-2.0
#include "skin_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace coupling::detail {
namespace {

constexpr double kMeet = 1e-9;  // share of the thickness: closer parts have met
constexpr double kAhead = 1.5;  // steps like the last one that are looked ahead
constexpr float kNever = -std::numeric_limits<float>::infinity();

}  // namespace

SkinSearch::SkinSearch(std::shared_ptr<const SkinParts> parts, bool every_pair)
    : parts_(std::move(parts)),
      every_pair_(every_pair),
      near_(2.0 * parts_->parameters.thickness),
      far_(near_ + 2.0 * parts_->mean_edge),
      margin_(1.0 * parts_->mean_edge),
      paths_(*parts_),
      boxes_at_mark_(*parts_),
      motion_(parts_->groups) {}

void SkinSearch::mark() {
  std::vector<Box> boxes;
  for (std::size_t g = 0; g < parts_->groups.count(); ++g)
    boxes.push_back(paths_.whole(*parts_, static_cast<int>(g)));
  const double reach = near_ + 2.0 * margin_ + paths_.rounding();
  std::vector<GroupPair> old;
  old.swap(pairs_);
  auto last = old.begin();
  for (const auto& [first, second] : near_boxes(boxes, static_cast<float>(reach))) {
    GroupPair pair{first, second};
    while (last != old.end() && std::pair(last->first, last->second) < std::pair(first, second)) ++last;
    if (last != old.end() && last->first == first && last->second == second) {
      pair = *last;
      const double since = motion_.since_mark(first, second);
      pair.rests = pair.rests && since < pair.slack;
      pair.slack -= since;
      pair.fresh = false;
    }
    pairs_.push_back(pair);
  }
  motion_.mark(now());
  boxes_at_mark_.stay(now());
  spent_ = 0;
  price_ = boxes.size() / 2;
}

bool SkinSearch::must_look(GroupPair& pair) {
  const double since = motion_.since_mark(pair.first, pair.second);
  const double ahead = kAhead * motion_.step(pair.first, pair.second);
  const bool rested = std::exchange(pair.rests, since + ahead < pair.slack);
  if (rested && pair.rests) return false;
  if (pair.level == level_ - 1) {
    pair.path += motion_.step(pair.first, pair.second);
    pair.level = level_;
    if (pair.path + ahead < pair.room) return false;
  }
  if (pair.fresh) return true;
  pair.fresh = true;
  ++price_;
  pair.slack =
      std::max(pair.slack, least_distance(boxes_at_mark_, pair, kNever) - parts_->parameters.thickness);
  pair.rests = since + ahead < pair.slack;
  return !(rested && pair.rests);
}

// One pair of parts: their distance [m].
double SkinSearch::look(const PartPair& pair) {
  const double reach = parts_->reach_of(pair.edges), meet = kMeet * parts_->parameters.thickness;
  const Corners corners = corners_of(*parts_, pair);
  const Quad x = positions(corners, now());
  const Closest closest = closest_of(pair.edges, x);
  ++looks_;
  if (!(closest.distance > meet)) throw_gap(*parts_, pair, 0.0);
  if (level_ == 0) {
    if (closest.distance < reach) touches_.push_back({pair, closest, closest.distance});
    return closest.distance;
  }
  const Quad y = positions(corners, before());
  const double motion = relative_motion(pair.edges, y, x);
  if (!(motion < closest.distance)) {
    ++sweeps_;
    if (paths_meet(pair.edges, y, x, meet)) throw_gap(*parts_, pair, motion);
  }
  const double closing = -closest.normal.dot((x - y) * closest.weight);
  // Parts that touch, or would ahead.
  if (closest.distance - kAhead * closing < reach) approach_ = std::max(approach_, closing / reach);
  if (closest.distance < reach) touches_.push_back({pair, closest, closest.distance - kAhead * closing});
  return closest.distance;
}

// A lower bound of the distance [m] of the parts of two groups, after a look at those within `near`.
double SkinSearch::least_distance(SkinBoxes& boxes, const GroupPair& pair, double near) {
  const SkinParts& parts = *parts_;
  const int first = pair.first, second = pair.second;
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
    for (const auto [row, lane] : found_) least = std::min(least, look(pair_of(row, lane)));
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

// Each pair of parts that are no neighbours, in the same order.
void SkinSearch::look_at_all() {
  const auto consider = [this](const PartPair& pair) {
    if (!parts_->neighbours(pair)) look(pair);
  };
  const auto consider_nodes = [&](int of_nodes, int of_elements) {
    for (const int e : parts_->group_elements(of_elements))
      for (const int n : parts_->group_nodes[of_nodes]) consider({n, e, false});
  };
  const auto groups = static_cast<int>(parts_->groups.count());
  for (int first = 0; first < groups; ++first)
    for (int second = first; second < groups; ++second) {
      consider_nodes(first, second);
      if (first != second) consider_nodes(second, first);
      const auto a = parts_->group_edges[first], b = parts_->group_edges[second];
      for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = first == second ? i + 1 : 0; k < b.size(); ++k) consider({a[i], b[k], true});
    }
}

void SkinSearch::follow(const Nodes& nodes) {
  touches_.clear();
  approach_ = 0.0;
  paths_.advance(nodes);
  motion_.update(now(), before());
  if (every_pair_) {
    look_at_all();
  } else {
    if (level_ == 0 || motion_.moved() + kAhead * motion_.largest_step() > margin_ || spent_ > price_) mark();
    for (GroupPair& pair : pairs_) {
      if (!must_look(pair)) continue;
      ++spent_;
      // What may touch ahead tells how fast it closes.
      const double thickness = parts_->parameters.thickness,
                   near = std::max(near_, thickness + kAhead * motion_.step(pair.first, pair.second));
      pair.room = least_distance(paths_, pair, near) - thickness;
      pair.path = 0.0;
      pair.level = level_;
    }
  }
  ++level_;
}

}  // namespace coupling::detail
