// SPDX-License-Identifier: Apache-2.0
#include "skin_search.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "check.hpp"
#include "skin_lists.hpp"

namespace coupling::detail {
namespace {

using Eigen::Array3d;
using Eigen::Vector3d;

constexpr double kMargin = 1.0 + 1e-12;  // margin for sums of motions
constexpr double kMeet = 1e-9;           // share of the thickness: closer parts have met

}  // namespace

SkinSearch::SkinSearch(std::shared_ptr<const SkinParts> parts, bool every_pair)
    : parts_(std::move(parts)),
      every_pair_(every_pair),
      pad_(0.25 * parts_->mean_edge),
      reach_(parts_->parameters.thickness + pad_ + 2.0 * parts_->mean_edge),
      boxes_(parts_->groups.count()),
      shift_(3, static_cast<Eigen::Index>(parts_->groups.count())),
      spread_(parts_->groups.count(), 0.0) {
  shift_.setZero();
}

void SkinSearch::measure(const Nodes& nodes) {
  const auto& groups = parts_->groups;
  step_ = nodes - previous_;
  double largest = 0.0, sum = 0.0;
  for (std::size_t g = 0; g < groups.count(); ++g) {
    const auto* const begin = groups.nodes.data() + groups.first_node[g];
    const auto* const end = groups.nodes.data() + groups.first_node[g + 1];
    Vector3d mean = Vector3d::Zero();
    for (const int* n = begin; n != end; ++n) mean += step_.col(*n);
    mean /= static_cast<double>(end - begin);
    double spread = 0.0;
    for (const int* n = begin; n != end; ++n) spread = std::max(spread, (step_.col(*n) - mean).squaredNorm());
    shift_.col(static_cast<Eigen::Index>(g)) = mean;
    spread_[g] = std::sqrt(spread);
    largest = std::max(largest, mean.norm() + spread_[g]);
    sum += mean.sum();  // a maximum ignores NaN, a sum does not
  }
  if (!std::isfinite(sum) || !std::isfinite(largest))
    throw ContactError("self-contact: a coordinate of a node is not finite");
  motion_ = 2.0 * kMargin * largest;
  travelled_ += motion_;
}

double SkinSearch::relative_step(const GroupPair& pair) const {
  const auto a = static_cast<std::size_t>(pair.first), b = static_cast<std::size_t>(pair.second);
  return kMargin * ((shift_.col(pair.first) - shift_.col(pair.second)).norm() + spread_[a] + spread_[b]);
}

const GroupBox& SkinSearch::box(int group, const Nodes& nodes) {
  GroupBox& box = boxes_[static_cast<std::size_t>(group)];
  if (box.level != level_) box = box_of_group(parts_->groups, group, nodes, level_);
  return box;
}

void SkinSearch::watch(const Nodes& nodes) {
  for (int g = 0; g < static_cast<int>(boxes_.size()); ++g) box(g, nodes);
  // What was not watched until now was `reach` apart when the watch began.
  const double due = level_ == 0 ? -std::numeric_limits<double>::infinity() : watch_end_;
  std::vector<GroupPair> found;
  for (const auto& [first, second] : near_boxes(boxes_, every_pair_ ? kEverywhere : reach_))
    found.push_back({.first = first, .second = second, .due = due, .list = {}});
  replace_pairs(std::move(found), nodes);
  watch_end_ = travelled_ + reach_ - pad_ - parts_->parameters.thickness;
}

// Keeps what is known of pairs that go on. Of the others it makes sure that they have not passed each other
// in the last step.
void SkinSearch::replace_pairs(std::vector<GroupPair> found, const Nodes& nodes) {
  const auto groups_of = [](const GroupPair& pair) { return std::pair(pair.first, pair.second); };
  auto old = pairs_.begin();
  const auto drop = [&] {
    if (old->listed || travelled_ >= old->due + pad_ + parts_->parameters.thickness) sweep(*old, nodes);
    ++old;
  };
  for (GroupPair& pair : found) {
    while (old != pairs_.end() && groups_of(*old) < groups_of(pair)) drop();
    if (old != pairs_.end() && groups_of(*old) == groups_of(pair)) pair = std::move(*old++);
  }
  while (old != pairs_.end()) drop();
  pairs_ = std::move(found);
}

// The motion may have brought the boxes of a pair together that is not listed.
void SkinSearch::look(GroupPair& pair, const Nodes& nodes) {
  const double near = pad_ + parts_->parameters.thickness;
  if (level_ > 0 && travelled_ >= pair.due + near) sweep(pair, nodes);
  const double gap = gap_of(box(pair.first, nodes), box(pair.second, nodes));
  if (gap > near + motion_ && !every_pair_) {
    pair.due = travelled_ + gap - near;
    return;
  }
  list(pair, nodes);
}

// Relative motion of a listed pair in the last step; a new list, if other parts may come near.
void SkinSearch::move(GroupPair& pair, const Nodes& nodes) {
  pair.step = relative_step(pair);
  pair.path += pair.step;
  if (pair.path + 2.0 * pair.step < pad_ || every_pair_) return;
  const double near = pad_ + parts_->parameters.thickness;
  if (pair.path >= pad_ + parts_->reach_of_edges()) {
    sweep(pair, nodes);
  } else {
    for (const Listed& entry : pair.list) {
      const double known = entry.free + parts_->reach_of(entry.pair.edges) - pair.path;
      if (known <= 0.0) certify(entry.pair, nodes, known + pair.step);
    }
  }
  const double gap = gap_of(box(pair.first, nodes), box(pair.second, nodes));
  if (gap > 2.0 * near + motion_) {
    pair.listed = false;
    pair.due = travelled_ + gap - near;
  } else {
    list(pair, nodes);
  }
}

void SkinSearch::list(GroupPair& pair, const Nodes& nodes) {
  pair.listed = true;
  pair.step = relative_step(pair);
  pair.path = 0.0;
  pair.wake = -std::numeric_limits<double>::infinity();
  pair.list.clear();
  const ListMaker maker{*parts_, nodes, every_pair_ ? kEverywhere : pad_, pair.list};
  maker.add_nodes(pair.first, box(pair.first, nodes), pair.second, box(pair.second, nodes));
  if (pair.first != pair.second)
    maker.add_nodes(pair.second, box(pair.second, nodes), pair.first, box(pair.first, nodes));
  maker.add_edges(pair.first, box(pair.first, nodes), pair.second, box(pair.second, nodes));
  looks_ += static_cast<long>(pair.list.size());
}

// Proves that two parts, `known` apart at the last level at least, have not met since.
void SkinSearch::certify(const PartPair& pair, const Nodes& nodes, double known) {
  const Corners corners = corners_of(*parts_, pair);
  const Quad from = positions(corners, previous_), to = positions(corners, nodes);
  const double motion = kMargin * relative_motion(pair.edges, from, to);
  if (motion < known) return;
  ++sweeps_;
  if (paths_meet(pair.edges, from, to, kMeet * parts_->parameters.thickness))
    throw_gap(*parts_, pair, motion);
}

// All parts of two groups, from the last level.
void SkinSearch::sweep(const GroupPair& pair, const Nodes& nodes) {
  std::vector<Listed> all;
  const ListMaker maker{*parts_, previous_, kEverywhere, all};
  const GroupBox none{};
  maker.add_nodes(pair.first, none, pair.second, none);
  if (pair.first != pair.second) maker.add_nodes(pair.second, none, pair.first, none);
  maker.add_edges(pair.first, none, pair.second, none);
  for (const Listed& entry : all) certify(entry.pair, nodes, entry.free + parts_->reach_of(entry.pair.edges));
}

void SkinSearch::visit(const GroupPair& pair, Listed& entry, const Nodes& nodes) {
  const bool edges = entry.pair.edges;
  const double reach = parts_->reach_of(edges);
  const Corners corners = corners_of(*parts_, entry.pair);
  const Quad x = positions(corners, nodes);
  const Closest closest = closest_of(edges, x);
  ++looks_;
  const double known = entry.free + reach - pair.path;
  if (level_ > 0 && known <= 0.0) certify(entry.pair, nodes, known + pair.step);
  entry.free = pair.path + closest.distance - reach;
  if (closest.distance >= reach + 2.0 * pair.step) return;
  if (!(closest.distance > kMeet * parts_->parameters.thickness)) throw_gap(*parts_, entry.pair, 0.0);
  if (level_ > 0) {
    const Quad moved = positions(corners, step_);
    const double closing = -closest.normal.dot(moved * closest.weight);
    if (closest.distance - closing < reach) approach_ = std::max(approach_, closing);
  }
  if (closest.distance < reach) touches_.push_back({entry.pair, closest});
}

void SkinSearch::visit(GroupPair& pair, const Nodes& nodes) {
  const double now = pair.path + 2.0 * pair.step;
  if (now < pair.wake && !every_pair_) return;
  pair.wake = std::numeric_limits<double>::infinity();
  for (Listed& entry : pair.list) {
    if (!(now < entry.free) || every_pair_) visit(pair, entry, nodes);
    pair.wake = std::min(pair.wake, entry.free);
  }
}

void SkinSearch::follow(const Nodes& nodes) {
  touches_.clear();
  approach_ = 0.0;
  if (level_ > 0)
    measure(nodes);
  else if (!nodes.allFinite())
    throw ContactError("self-contact: a coordinate of a node is not finite");
  else
    step_ = Eigen::Matrix3Xd::Zero(3, nodes.cols());
  if (level_ == 0 || travelled_ + motion_ >= watch_end_) watch(nodes);
  for (GroupPair& pair : pairs_) {
    if (pair.listed)
      move(pair, nodes);
    else if (travelled_ + motion_ >= pair.due)
      look(pair, nodes);
    if (pair.listed) visit(pair, nodes);
  }
  previous_ = nodes;
  ++level_;
}

}  // namespace coupling::detail
