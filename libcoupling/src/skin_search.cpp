// SPDX-License-Identifier: Apache-2.0
#include "skin_search.hpp"

#include <algorithm>
#include <utility>

namespace coupling::detail {

SkinSearch::SkinSearch(std::shared_ptr<const SkinParts> parts, bool every_pair)
    : parts_(std::move(parts)),
      every_pair_(every_pair),
      margin_(static_cast<float>(parts_->mean_edge)),
      motion_(parts_->groups, kAhead),
      boxes_(*parts_),
      awake_(parts_->groups.count(), 0.0) {}

void SkinSearch::pair_groups() {
  std::vector<Box> boxes;
  for (std::size_t g = 0; g < parts_->groups.count(); ++g)
    boxes.push_back(motion_.group_box(static_cast<int>(g)));
  const float reach =
      2.0F * (static_cast<float>(parts_->parameters.thickness) + margin_) + motion_.rounding();
  const std::vector<GroupPair> old = std::exchange(pairs_, {});
  auto last = old.begin();
  const auto numbers = [](const GroupPair& pair) { return std::pair(pair.first, pair.second); };
  for (const auto& [first, second] : near_boxes(boxes, reach)) {
    const std::pair both(first, second);
    while (last != old.end() && numbers(*last) < both) ++last;
    if (last != old.end() && numbers(*last) == both)
      pairs_.push_back(*last);
    else
      pairs_.push_back({first, second, parts_->masks.of(first, second), 0.0});
  }
  moved_ = 0.0F;
}

// A lower bound of the distance [m] of the parts of two groups. Looks at all that may touch ahead.
double SkinSearch::least_distance(const GroupPair& pair, const SkinLimits& limits) {
  const GroupBoxes &a = boxes_.of(pair.first, motion_), &b = boxes_.of(pair.second, motion_);
  const double reach = std::max(limits.reach_of_nodes(pair.first), limits.reach_of_nodes(pair.second));
  if (const float apart = gap(a.whole, b.whole); apart > reach + motion_.rounding())
    return apart - motion_.rounding();
  // Distances beyond that are not worked out.
  double least = 1.2F * static_cast<float>(parts_->parameters.thickness + parts_->mean_edge);
  const double most = motion_.step(pair.first) + motion_.step(pair.second);
  const std::uint64_t* mask = pair.mask;
  const auto search = [&](double within, const PartBoxes& rows, const PartBoxes& lanes, const Box& whole,
                          auto&& pair_of) {
    found_.clear();
    const float near = static_cast<float>(within) + motion_.rounding();
    least = std::min<double>(least,
                             least_gap({rows, lanes, whole, mask}, near, static_cast<float>(least), found_));
    for (const auto [row, lane] : found_)
      least = std::min(least, looks_.look(*parts_, limits, pair_of(row, lane), most, before(), now()));
    if (mask) mask += rows.count;
  };
  const auto search_nodes = [&](const GroupBoxes& nodes, int of_nodes, const GroupBoxes& elements,
                                int of_elements) {
    search(limits.reach_of_nodes(of_nodes), elements.elements, nodes.nodes, nodes.whole,
           [&](std::size_t row, std::size_t lane) {
             return PartPair{parts_->group_nodes[of_nodes][lane], parts_->group_elements(of_elements)[row],
                             false};
           });
  };
  search_nodes(a, pair.first, b, pair.second);
  if (pair.first != pair.second) search_nodes(b, pair.second, a, pair.first);
  const double of_edges = std::min(limits.reach_of_edges(pair.first), limits.reach_of_edges(pair.second));
  search(of_edges, a.edges, b.edges, b.whole, [&](std::size_t row, std::size_t lane) {
    return PartPair{parts_->group_edges[pair.first][row], parts_->group_edges[pair.second][lane], true};
  });
  return least - motion_.rounding();
}

void SkinSearch::go_on_from(const SkinContactRecord& record) {
  looks_.level = record.level;
  looks_.looks = record.looks;
  looks_.sweeps = record.sweeps;
  if (record.level < 0) return;
  motion_.advance(record.nodes);
  moved_ = 2.0F * margin_;  // groups are paired at the next level
}

void SkinSearch::follow(const Nodes& nodes, const SkinLimits& limits) {
  looks_.advance();
  motion_.advance(nodes);
  if (every_pair_) return looks_.look_at_all(*parts_, limits, before(), now());
  const auto ahead_of = [](float step) { return static_cast<float>(kAhead) * step; };
  moved_ += motion_.largest_step();
  if (looks_.level == 0 || moved_ + ahead_of(motion_.largest_step()) > margin_) pair_groups();
  boxes_.forget();
  for (int g = 0; g < static_cast<int>(awake_.size()); ++g)
    awake_[static_cast<std::size_t>(g)] = motion_.path(g) + ahead_of(motion_.step(g));
  for (GroupPair& pair : pairs_) {
    const auto a = static_cast<std::size_t>(pair.first), b = static_cast<std::size_t>(pair.second);
    const double reach = std::max(limits.reach_of_nodes(pair.first), limits.reach_of_nodes(pair.second));
    if (awake_[a] + awake_[b] + reach < pair.wakes) continue;
    pair.wakes = motion_.path(pair.first) + motion_.path(pair.second) + least_distance(pair, limits);
  }
}

}  // namespace coupling::detail
