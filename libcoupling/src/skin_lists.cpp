// SPDX-License-Identifier: Apache-2.0
#include "skin_lists.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace coupling::detail {
namespace {

using Eigen::Array3d;

struct Box {
  Array3d low, high;
};

bool apart(const Box& a, const Array3d& low, const Array3d& high, double distance) {
  return (a.low > high + distance).any() || (a.high < low - distance).any();
}

/// A part with its box.
struct Boxed {
  int part;
  Box box;
};
// No group has more nodes or edges than corners of its elements.
using BoxedParts = std::array<Boxed, 3 * ElementGroups::kSize>;

}  // namespace

GroupBox box_of_group(const ElementGroups& groups, int group, const Nodes& nodes, long level) {
  GroupBox box{level, Array3d::Constant(kEverywhere), Array3d::Constant(-kEverywhere)};
  const auto g = static_cast<std::size_t>(group);
  for (std::size_t k = groups.first_node[g]; k < groups.first_node[g + 1]; ++k) {
    const Array3d x = nodes.col(groups.nodes[k]);
    box.low = box.low.min(x);
    box.high = box.high.max(x);
  }
  return box;
}

double gap_of(const GroupBox& a, const GroupBox& b) {
  return (a.low - b.high).max(b.low - a.high).max(0.0).matrix().norm() * (1.0 - 1e-12);
}

std::vector<std::pair<int, int>> near_boxes(const std::vector<GroupBox>& boxes, double reach) {
  Array3d low = Array3d::Constant(kEverywhere), high = -low;
  for (const GroupBox& box : boxes) {
    low = low.min(box.low);
    high = high.max(box.high);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  std::vector<int> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  const auto box_of = [&](int g) -> const GroupBox& { return boxes[static_cast<std::size_t>(g)]; };
  std::ranges::sort(order, {}, [&](int g) { return std::pair(box_of(g).low[axis], g); });
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const GroupBox& a = box_of(order[i]);
    for (std::size_t j = i; j < order.size() && box_of(order[j]).low[axis] <= a.high[axis] + reach; ++j)
      if (gap_of(a, box_of(order[j])) <= reach) pairs.push_back(std::minmax(order[i], order[j]));
  }
  std::ranges::sort(pairs);
  return pairs;
}

void ListMaker::add(const PartPair& pair) const {
  const double distance = closest_of(pair.edges, positions(corners_of(parts, pair), nodes)).distance;
  const double free = distance - parts.reach_of(pair.edges);
  if (free < pad || pad == kEverywhere) list.push_back({pair, free});
}

void ListMaker::add_nodes(int first, const GroupBox& first_box, int second,
                          const GroupBox& second_box) const {
  const bool all = pad == kEverywhere;
  const double near = pad + parts.parameters.thickness;
  BoxedParts mine;
  std::size_t count = 0;
  for (const int n : parts.group_nodes[first]) {
    const Array3d x = nodes.col(n);
    if (all || !apart({x, x}, second_box.low, second_box.high, near)) mine[count++] = {n, {x, x}};
  }
  if (count == 0) return;
  const auto& elements = parts.groups.elements;
  const auto begin = static_cast<std::size_t>(second) * ElementGroups::kSize;
  const std::size_t end = std::min(begin + ElementGroups::kSize, elements.size());
  for (std::size_t k = begin; k < end; ++k) {
    const auto corner = parts.triangles.col(elements[k]);
    const Array3d a = nodes.col(corner[0]), b = nodes.col(corner[1]), c = nodes.col(corner[2]);
    const Box box{a.min(b).min(c), a.max(b).max(c)};
    if (!all && apart(box, first_box.low, first_box.high, near)) continue;
    for (std::size_t i = 0; i < count; ++i) {
      const int n = mine[i].part;
      if ((!all && apart(mine[i].box, box.low, box.high, near)) || (corner.array() == n).any()) continue;
      add({n, elements[k], false});
    }
  }
}

void ListMaker::add_edges(int first, const GroupBox& first_box, int second,
                          const GroupBox& second_box) const {
  const bool all = pad == kEverywhere;
  const double near = pad + parts.reach_of_edges();
  const auto near_to = [&](int group, const GroupBox& other, BoxedParts& found) {
    std::size_t count = 0;
    for (const int e : parts.group_edges[group]) {
      const auto [p, q] = parts.edges[static_cast<std::size_t>(e)];
      const Array3d a = nodes.col(p), b = nodes.col(q);
      const Box box{a.min(b), a.max(b)};
      if (all || !apart(box, other.low, other.high, near)) found[count++] = {e, box};
    }
    return count;
  };
  BoxedParts mine, others;
  const std::size_t m = near_to(first, second_box, mine);
  const std::size_t n = m == 0 ? 0 : near_to(second, first_box, others);
  for (std::size_t i = 0; i < m; ++i) {
    const auto [a, b] = parts.edges[static_cast<std::size_t>(mine[i].part)];
    for (std::size_t j = first == second ? i + 1 : 0; j < n; ++j) {
      if (!all && apart(mine[i].box, others[j].box.low, others[j].box.high, near)) continue;
      const auto [c, d] = parts.edges[static_cast<std::size_t>(others[j].part)];
      if (a != c && a != d && b != c && b != d) add({mine[i].part, others[j].part, true});
    }
  }
}

}  // namespace coupling::detail
