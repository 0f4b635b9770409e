// SPDX-License-Identifier: Apache-2.0
#include "skin_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace coupling::detail {

SkinSearch::SkinSearch(std::shared_ptr<const SkinParts> parts, bool every_pair)
    : parts_(std::move(parts)),
      every_pair_(every_pair),
      margin_(parts_->mean_edge),
      looks_(*parts_),
      boxes_at_mark_(*parts_),
      motion_(parts_->groups) {}

void SkinSearch::mark() {
  std::vector<Box> boxes;
  for (std::size_t g = 0; g < parts_->groups.count(); ++g)
    boxes.push_back(looks_.paths.whole(*parts_, static_cast<int>(g)));
  const double reach = 2.0 * (parts_->parameters.thickness + margin_) + looks_.paths.rounding();
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
  if (pair.level == looks_.level - 1) {
    pair.path += motion_.step(pair.first, pair.second);
    pair.level = looks_.level;
    if (pair.path + ahead < pair.room) return false;
  }
  if (pair.fresh) return true;
  pair.fresh = true;
  ++price_;
  pair.slack =
      std::max(pair.slack, looks_.least_distance(*parts_, boxes_at_mark_, pair.first, pair.second, 0.0) -
                               parts_->parameters.thickness);
  pair.rests = since + ahead < pair.slack;
  return !(rested && pair.rests);
}

void SkinSearch::follow(const Nodes& nodes) {
  looks_.advance(nodes);
  motion_.update(now(), before());
  if (every_pair_) {
    looks_.look_at_all(*parts_);
  } else {
    if (looks_.level == 0 || motion_.moved() + kAhead * motion_.largest_step() > margin_ || spent_ > price_)
      mark();
    for (GroupPair& pair : pairs_) {
      if (!must_look(pair)) continue;
      ++spent_;
      const double ahead = kAhead * motion_.step(pair.first, pair.second);
      pair.room = looks_.least_distance(*parts_, looks_.paths, pair.first, pair.second, ahead) -
                  parts_->parameters.thickness;
      pair.path = 0.0;
      pair.level = looks_.level;
    }
  }
}

}  // namespace coupling::detail
