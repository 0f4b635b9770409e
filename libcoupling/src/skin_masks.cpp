// SPDX-License-Identifier: Apache-2.0
#include "skin_masks.hpp"

#include <algorithm>
#include <span>

#include "skin_parts.hpp"

namespace coupling::detail {
namespace {

// Pairs of groups of which a node of one is a node of the other, or an edge joins them.
std::vector<std::pair<int, int>> adjacent_groups(const SkinParts& parts) {
  const ElementGroups& groups = parts.groups;
  std::vector<std::vector<int>> groups_at(parts.masses.size());
  for (std::size_t g = 0; g < groups.count(); ++g)
    for (std::size_t k = groups.first_node[g]; k < groups.first_node[g + 1]; ++k)
      groups_at[static_cast<std::size_t>(groups.nodes[k])].push_back(static_cast<int>(g));
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t g = 0; g < groups.count(); ++g) {
    std::vector<int> near{static_cast<int>(g)};
    for (std::size_t k = groups.first_node[g]; k < groups.first_node[g + 1]; ++k)
      for (const int n : parts.neighbours_of[groups.nodes[k]]) {
        const auto& at = groups_at[static_cast<std::size_t>(n)];
        near.insert(near.end(), at.begin(), at.end());
      }
    std::ranges::sort(near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (const int other : near)
      if (other >= static_cast<int>(g)) pairs.emplace_back(g, other);
  }
  return pairs;
}

}  // namespace

PartMasks::PartMasks(const SkinParts& parts) : pairs_(adjacent_groups(parts)) {
  const auto add = [&](std::span<const int> rows, std::span<const int> lanes, const auto& may_touch) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      std::uint64_t word = 0;
      for (std::size_t k = 0; k < lanes.size(); ++k)
        if (may_touch(i, k)) word |= std::uint64_t{1} << k;
      words_.push_back(word);
    }
  };
  const auto add_nodes = [&](std::span<const int> elements, std::span<const int> nodes) {
    add(elements, nodes, [&](std::size_t i, std::size_t k) {
      return !parts.neighbours({nodes[k], elements[i], false});
    });
  };
  for (const auto& [first, second] : pairs_) {
    start_.push_back(words_.size());
    add_nodes(parts.group_elements(second), parts.group_nodes[first]);
    if (first != second) add_nodes(parts.group_elements(first), parts.group_nodes[second]);
    const auto a = parts.group_edges[first], b = parts.group_edges[second];
    add(a, b, [&, same = first == second](std::size_t i, std::size_t k) {
      return !(same && k <= i) && !parts.neighbours({a[i], b[k], true});
    });
  }
}

const std::uint64_t* PartMasks::of(int first, int second) const {
  const auto found = std::ranges::lower_bound(pairs_, std::pair(first, second));
  if (found == pairs_.end() || *found != std::pair(first, second)) return nullptr;
  return words_.data() + start_[static_cast<std::size_t>(found - pairs_.begin())];
}

}  // namespace coupling::detail
