// SPDX-License-Identifier: Apache-2.0
#include "skin_lists.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

namespace coupling::detail {
namespace {

// Places of the boxes that come within `range` of another; no group has more parts of a kind than corners.
struct Near {
  std::size_t count = 0;
  std::array<int, 3 * ElementGroups::kSize> place;
  Near(const std::vector<PathBox>& boxes, const PathBox& other, double range) {
    for (std::size_t i = 0; i < boxes.size(); ++i)
      if (!boxes[i].apart(other, range)) place[count++] = static_cast<int>(i);
  }
};

std::span<const int> elements_of(const ElementGroups& groups, int group) {
  const auto begin = static_cast<std::size_t>(group) * ElementGroups::kSize;
  return std::span(groups.elements)
      .subspan(begin, std::min(ElementGroups::kSize, groups.elements.size() - begin));
}

}  // namespace

std::vector<std::pair<int, int>> near_boxes(const std::vector<PathBox>& boxes, double reach) {
  PathBox all;
  for (const PathBox& box : boxes) {
    all.add(box.low);
    all.add(box.high);
  }
  int axis = 0;
  (all.high - all.low).maxCoeff(&axis);
  std::vector<int> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  const auto box_of = [&](int g) -> const PathBox& { return boxes[static_cast<std::size_t>(g)]; };
  std::ranges::sort(order, {}, [&](int g) { return std::pair(box_of(g).low[axis], g); });
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const PathBox& a = box_of(order[i]);
    for (std::size_t j = i; j < order.size() && box_of(order[j]).low[axis] <= a.high[axis] + reach; ++j)
      if (!a.apart(box_of(order[j]), reach)) pairs.push_back(std::minmax(order[i], order[j]));
  }
  std::ranges::sort(pairs);
  return pairs;
}

void PartSearch::consider(const PartPair& pair, const PathBox& first, const PathBox& second) {
  if (first.apart(second, range()) || first.gap(second) > range() || parts_.neighbours(pair)) return;
  least_ = std::min(least_, look_(pair));
}

void PartSearch::search_nodes(int first, const GroupPaths& first_paths, int second,
                              const GroupPaths& second_paths) {
  const auto nodes = parts_.group_nodes[first];
  const auto elements = elements_of(parts_.groups, second);
  const Near mine(first_paths.nodes, second_paths.whole, range());
  if (mine.count == 0) return;
  const Near others(second_paths.elements, first_paths.whole, range());
  for (std::size_t k = 0; k < others.count; ++k)
    for (std::size_t i = 0; i < mine.count; ++i) {
      const auto n = static_cast<std::size_t>(mine.place[i]), e = static_cast<std::size_t>(others.place[k]);
      consider({nodes[n], elements[e], false}, first_paths.nodes[n], second_paths.elements[e]);
    }
}

void PartSearch::search_edges(int first, const GroupPaths& first_paths, int second,
                              const GroupPaths& second_paths) {
  const auto first_edges = parts_.group_edges[first], second_edges = parts_.group_edges[second];
  const Near mine(first_paths.edges, second_paths.whole, range());
  if (mine.count == 0) return;
  const Near others(second_paths.edges, first_paths.whole, range());
  for (std::size_t i = 0; i < mine.count; ++i)
    for (std::size_t k = first == second ? i + 1 : 0; k < others.count; ++k) {
      const auto a = static_cast<std::size_t>(mine.place[i]), b = static_cast<std::size_t>(others.place[k]);
      consider({first_edges[a], second_edges[b], true}, first_paths.edges[a], second_paths.edges[b]);
    }
}

double PartSearch::search(int first, const GroupPaths& first_paths, int second,
                          const GroupPaths& second_paths) {
  search_nodes(first, first_paths, second, second_paths);
  if (first != second) search_nodes(second, second_paths, first, first_paths);
  search_edges(first, first_paths, second, second_paths);
  return least_;
}

SkinPaths::SkinPaths(const SkinParts& parts)
    : groups_(parts.groups.count()),
      whole_level_(parts.groups.count(), -1),
      parts_level_(parts.groups.count(), -1) {}

void SkinPaths::advance(const Nodes& nodes) {
  before_.swap(now_);
  now_ = nodes;
  if (++level_ == 0) before_ = now_;
}

template <class Corners>
PathBox SkinPaths::box(const Corners& nodes) const {
  PathBox box;
  for (const int n : nodes) {
    box.add(now_.col(n));
    box.add(before_.col(n));
  }
  return box;
}

const PathBox& SkinPaths::whole(const SkinParts& parts, int group) {
  const auto g = static_cast<std::size_t>(group);
  if (whole_level_[g] != level_) {
    const std::size_t begin = parts.groups.first_node[g], end = parts.groups.first_node[g + 1];
    groups_[g].whole = box(std::span(parts.groups.nodes).subspan(begin, end - begin));
    whole_level_[g] = level_;
  }
  return groups_[g].whole;
}

const GroupPaths& SkinPaths::of(const SkinParts& parts, int group) {
  const auto g = static_cast<std::size_t>(group);
  whole(parts, group);
  GroupPaths& paths = groups_[g];
  if (parts_level_[g] == level_) return paths;
  parts_level_[g] = level_;
  paths.nodes.clear();
  paths.elements.clear();
  paths.edges.clear();
  for (const int n : parts.group_nodes[group]) paths.nodes.push_back(box(std::array{n}));
  for (const int e : elements_of(parts.groups, group)) paths.elements.push_back(box(parts.triangles.col(e)));
  for (const int e : parts.group_edges[group])
    paths.edges.push_back(box(parts.edges[static_cast<std::size_t>(e)]));
  return paths;
}

}  // namespace coupling::detail
