// SPDX-License-Identifier: Apache-2.0
#include "skin_boxes.hpp"

#include <algorithm>
#include <limits>

#include "skin_lanes.hpp"

namespace coupling::detail {
namespace {

constexpr float kFarAway = std::numeric_limits<float>::infinity();

void reserve(PartBoxes& boxes, std::size_t count) {
  boxes.count = count;
  boxes.stride = (count + kLanes - 1) / kLanes * kLanes;
  boxes.low.assign(boxes.stride * 8, kFarAway);
  boxes.high.assign(boxes.stride * 8, -kFarAway);
}

// Boxes of parts with that number of corners, four at a time.
template <std::size_t kCorners>
void fill(PartBoxes& boxes, const std::vector<int>& corners, const SkinMotion& motion) {
  for (std::size_t begin = 0; begin < boxes.count; begin += 4) {
    const std::size_t count = std::min<std::size_t>(4, boxes.count - begin);
    std::array<Box, 4> part;
    part.fill(empty_box());
    for (std::size_t i = 0; i < count; ++i) {
      const int* corner = corners.data() + kCorners * (begin + i);
      part[i] = motion.path_box(corner[0]);
      for (std::size_t k = 1; k < kCorners; ++k) add(part[i], motion.path_box(corner[k]));
    }
    for (std::size_t d = 0; d < 8; d += 4) {
      const auto store_directions = [&](std::vector<float>& to, auto bound) {
        const auto rows = transposed({load((part[0].*bound).data() + d), load((part[1].*bound).data() + d),
                                      load((part[2].*bound).data() + d), load((part[3].*bound).data() + d)});
        for (std::size_t k = 0; k < 4; ++k) store(to.data() + (d + k) * boxes.stride + begin, rows[k]);
      };
      store_directions(boxes.low, &Box::low);
      store_directions(boxes.high, &Box::high);
    }
  }
}

}  // namespace

SkinBoxes::SkinBoxes(const SkinParts& parts)
    : groups_(parts.groups.count()), known_(parts.groups.count(), -1), corners_(parts.groups.count()) {
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    auto& [of_nodes, of_edges, of_elements] = corners_[g];
    const auto group = static_cast<int>(g);
    for (const int n : parts.group_nodes[group]) of_nodes.push_back(n);
    for (const int e : parts.group_edges[group])
      for (const int n : parts.edges[static_cast<std::size_t>(e)]) of_edges.push_back(n);
    for (const int e : parts.group_elements(group))
      for (const int n : parts.triangles.col(e)) of_elements.push_back(n);
    reserve(groups_[g].nodes, of_nodes.size());
    reserve(groups_[g].edges, of_edges.size() / 2);
    reserve(groups_[g].elements, of_elements.size() / 3);
  }
}

const GroupBoxes& SkinBoxes::of(int group, const SkinMotion& motion) {
  const auto g = static_cast<std::size_t>(group);
  GroupBoxes& boxes = groups_[g];
  if (known_[g] == level_) return boxes;
  known_[g] = level_;
  boxes.whole = motion.group_box(group);
  fill<1>(boxes.nodes, corners_[g][0], motion);
  fill<2>(boxes.edges, corners_[g][1], motion);
  fill<3>(boxes.elements, corners_[g][2], motion);
  return boxes;
}

}  // namespace coupling::detail
