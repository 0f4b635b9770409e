// SPDX-License-Identifier: Apache-2.0
#include "skin_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coupling::detail {
namespace {

constexpr double kMeet = 1e-9;  // share of the thickness: closer parts have met
// Shares of the mean edge: parts farther apart than this are not looked at, at a mark and later. A far look
// lasts longer and costs more.
constexpr double kFar = 1.2, kNear = 0.6;
// Steps like the last one that are looked ahead.
constexpr double kAhead = 1.5;

}  // namespace

SkinSearch::SkinSearch(std::shared_ptr<const SkinParts> parts, bool every_pair)
    : parts_(std::move(parts)),
      every_pair_(every_pair),
      margin_(2.0 * parts_->mean_edge),
      paths_(*parts_),
      motion_(parts_->groups) {}

void SkinSearch::mark() {
  std::vector<PathBox> boxes;
  for (std::size_t g = 0; g < parts_->groups.count(); ++g)
    boxes.push_back(paths_.whole(*parts_, static_cast<int>(g)));
  const double range = parts_->parameters.thickness + kFar * parts_->mean_edge;
  pairs_.clear();
  for (const auto& [first, second] : near_boxes(boxes, every_pair_ ? kEverywhere : range + 2.0 * margin_))
    pairs_.push_back({first, second});
  motion_.mark(paths_.now());
  spent_ = price_ = 0;
}

bool SkinSearch::must_look(GroupPair& pair) {
  if (every_pair_ || pair.slack < 0.0) return true;
  const double ahead = kAhead * motion_.step(pair.first, pair.second);
  if (motion_.since_mark(pair.first, pair.second) + ahead < pair.slack) return false;
  if (pair.level != level_ - 1) return true;
  pair.path += motion_.step(pair.first, pair.second);
  pair.level = level_;
  return !(pair.path + ahead < pair.room);
}

// One pair of parts: their distance [m].
double SkinSearch::look(const PartPair& pair) {
  const double reach = parts_->reach_of(pair.edges), meet = kMeet * parts_->parameters.thickness;
  const Corners corners = corners_of(*parts_, pair);
  const Quad x = positions(corners, paths_.now());
  const Closest closest = closest_of(pair.edges, x);
  ++looks_;
  if (!(closest.distance > meet)) throw_gap(*parts_, pair, 0.0);
  if (level_ == 0) {
    if (closest.distance < reach) touches_.push_back({pair, closest, closest.distance});
    return closest.distance;
  }
  const Quad y = positions(corners, paths_.before());
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

// The parts of two groups, of which those that may touch ahead tell how fast they close: a lower bound of
// their distance, at most the range [m].
double SkinSearch::look(const GroupPair& pair, double range) {
  const double near = parts_->parameters.thickness + kAhead * motion_.step(pair.first, pair.second);
  range = std::max(range, near);
  if (paths_.whole(*parts_, pair.first).apart(paths_.whole(*parts_, pair.second), range)) return range;
  ++(marking_ ? price_ : spent_);
  const PartSearch::Look look_at = [this](const PartPair& parts) { return look(parts); };
  return PartSearch(*parts_, near, range, look_at)
      .search(pair.first, paths_.of(*parts_, pair.first), pair.second, paths_.of(*parts_, pair.second));
}

void SkinSearch::follow(const Nodes& nodes) {
  touches_.clear();
  approach_ = 0.0;
  paths_.advance(nodes);
  motion_.update(paths_.now(), paths_.before());
  marking_ = level_ == 0 || motion_.moved() > margin_ || spent_ > price_;
  if (marking_) mark();
  const double thickness = parts_->parameters.thickness;
  const double range = every_pair_ ? kEverywhere : thickness + (marking_ ? kFar : kNear) * parts_->mean_edge;
  for (GroupPair& pair : pairs_) {
    if (!must_look(pair)) continue;
    pair.room = look(pair, range) - thickness;
    pair.path = 0.0;
    pair.level = level_;
    if (marking_) pair.slack = std::max(0.0, pair.room);
  }
  ++level_;
}

}  // namespace coupling::detail
