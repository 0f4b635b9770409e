// SPDX-License-Identifier: Apache-2.0
#include "skin_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace coupling::detail {
namespace {

constexpr float kFarAway = std::numeric_limits<float>::infinity();

std::span<const int> nodes_of(const ElementGroups& groups, std::size_t g) {
  return std::span(groups.nodes)
      .subspan(groups.first_node[g], groups.first_node[g + 1] - groups.first_node[g]);
}

void reserve(PartBoxes& boxes, std::size_t count) {
  boxes.count = count;
  boxes.stride = (count + kLanes - 1) / kLanes * kLanes;
  boxes.low.assign(boxes.stride * kDirections, kFarAway);
  boxes.high.assign(boxes.stride * kDirections, -kFarAway);
}

// Coordinates along the directions: the axes and, if wanted, the diagonals of a cube.
std::array<float, 8> along_directions(const Eigen::Vector3d& x) {
  constexpr float third = 0.57735026F;
  const auto a = static_cast<float>(x[0]), b = static_cast<float>(x[1]), c = static_cast<float>(x[2]);
  const float sum = third * (a + b), difference = third * (a - b), d = third * c;
  return {a, b, c, sum + d, sum - d, difference + d, difference - d, 0.0F};
}

void add(Box& box, const std::array<float, 8>& low, const std::array<float, 8>& high) {
  for (std::size_t k = 0; k < 8; ++k) {
    box.low[k] = std::min(box.low[k], low[k]);
    box.high[k] = std::max(box.high[k], high[k]);
  }
}

Box empty_box() {
  Box box;
  box.low.fill(kFarAway);
  box.high.fill(-kFarAway);
  return box;
}

}  // namespace

float gap(const Box& a, const Box& b) {
  float gap = -kFarAway;
  for (std::size_t k = 0; k < kDirections; ++k)
    gap = std::max(gap, std::max(a.low[k] - b.high[k], b.low[k] - a.high[k]));
  return gap;
}

SkinBoxes::SkinBoxes(const SkinParts& parts)
    : origin_node_(parts.groups.nodes.front()),
      groups_(parts.groups.count()),
      corners_(parts.groups.count()),
      whole_level_(parts.groups.count(), -1),
      parts_level_(parts.groups.count(), -1) {
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const auto nodes = nodes_of(parts.groups, g);
    auto& [of_nodes, of_elements, of_edges] = corners_[g];
    const auto place = [&](int node) {
      return static_cast<std::uint8_t>(std::ranges::lower_bound(nodes, node) - nodes.begin());
    };
    const auto group = static_cast<int>(g);
    for (const int n : parts.group_nodes[group]) of_nodes.push_back(place(n));
    for (const int e : parts.group_elements(group))
      for (const int n : parts.triangles.col(e)) of_elements.push_back(place(n));
    for (const int e : parts.group_edges[group])
      for (const int n : parts.edges[static_cast<std::size_t>(e)]) of_edges.push_back(place(n));
    reserve(groups_[g].nodes, of_nodes.size());
    reserve(groups_[g].elements, of_elements.size() / 3);
    reserve(groups_[g].edges, of_edges.size() / 2);
  }
}

void SkinBoxes::advance(const Nodes& nodes) {
  before_.swap(now_);
  now_ = nodes;
  if (++level_ == 0) before_ = now_;
  origin_ = now_.col(origin_node_);
}

void SkinBoxes::stay(const Nodes& nodes) {
  now_ = nodes;
  advance(nodes);
}

void SkinBoxes::fill_nodes(const SkinParts& parts, std::size_t g) {
  node_boxes_.clear();
  for (const int n : nodes_of(parts.groups, g)) {
    const auto a = along_directions(before_.col(n) - origin_), b = along_directions(now_.col(n) - origin_);
    Box box;
    for (std::size_t k = 0; k < 8; ++k) {
      box.low[k] = std::min(a[k], b[k]);
      box.high[k] = std::max(a[k], b[k]);
    }
    node_boxes_.push_back(box);
  }
}

const Box& SkinBoxes::whole(const SkinParts& parts, int group) {
  const auto g = static_cast<std::size_t>(group);
  if (whole_level_[g] != level_) {
    fill_nodes(parts, g);
    Box box = empty_box();
    for (const Box& node : node_boxes_) add(box, node.low, node.high);
    groups_[g].whole = box;
    whole_level_[g] = level_;
    for (std::size_t k = 0; k < 3; ++k)
      rounding_ = std::max({rounding_, 2e-6F * std::abs(box.low[k]), 2e-6F * std::abs(box.high[k])});
  }
  return groups_[g].whole;
}

void SkinBoxes::fill(PartBoxes& boxes, std::size_t corners, const std::vector<std::uint8_t>& corner_of) {
  for (std::size_t i = 0; i < boxes.count; ++i) {
    Box box = node_boxes_[corner_of[corners * i]];
    for (std::size_t c = 1; c < corners; ++c) {
      const Box& other = node_boxes_[corner_of[corners * i + c]];
      add(box, other.low, other.high);
    }
    for (std::size_t k = 0; k < kDirections; ++k) {
      boxes.low[k * boxes.stride + i] = box.low[k];
      boxes.high[k * boxes.stride + i] = box.high[k];
    }
  }
}

const GroupBoxes& SkinBoxes::of(const SkinParts& parts, int group) {
  const auto g = static_cast<std::size_t>(group);
  whole(parts, group);
  if (parts_level_[g] == level_) return groups_[g];
  parts_level_[g] = level_;
  fill_nodes(parts, g);
  fill(groups_[g].nodes, 1, corners_[g][0]);
  fill(groups_[g].elements, 3, corners_[g][1]);
  fill(groups_[g].edges, 2, corners_[g][2]);
  return groups_[g];
}

std::vector<std::pair<int, int>> near_boxes(const std::vector<Box>& boxes, float reach) {
  Box all = empty_box();
  for (const Box& box : boxes) add(all, box.low, box.high);
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (all.high[k] - all.low[k] > all.high[axis] - all.low[axis]) axis = k;
  std::vector<int> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  const auto box_of = [&](int g) -> const Box& { return boxes[static_cast<std::size_t>(g)]; };
  std::ranges::sort(order, {}, [&](int g) { return std::pair(box_of(g).low[axis], g); });
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Box& a = box_of(order[i]);
    for (std::size_t j = i; j < order.size() && box_of(order[j]).low[axis] - a.high[axis] <= reach; ++j)
      if (gap(a, box_of(order[j])) <= reach) pairs.push_back(std::minmax(order[i], order[j]));
  }
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace coupling::detail
