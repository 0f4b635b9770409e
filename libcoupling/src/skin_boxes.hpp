// SPDX-License-Identifier: Apache-2.0
// Boxes of the paths of a skin's groups and parts over a step, in single precision.
#pragma once
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "skin_parts.hpp"

namespace coupling::detail {

// Directions along which a box has bounds: the axes first.
inline constexpr int kDirections = 7;
inline constexpr std::size_t kLanes = 8;  // parts whose boxes are compared at once

/// Bounds [m] along the directions.
struct Box {
  std::array<float, 8> low, high;  // the last one is not used
};
/// Distance of two boxes along one of the directions [m]; negative if they overlap.
float gap(const Box& a, const Box& b);

/// Boxes of the parts of one kind of a group, and none up to a multiple of the lanes.
struct PartBoxes {
  std::size_t count = 0, stride = 0;
  std::vector<float> low, high;  // [direction * stride + part]
};

struct GroupBoxes {
  Box whole;
  PartBoxes nodes, elements, edges;  // in their order in the group
};

/// The boxes of all groups between two levels; each is worked out when it is first asked for.
class SkinBoxes {
 public:
  explicit SkinBoxes(const SkinParts& parts);

  /// Goes on to the next positions, 3 x N [m].
  void advance(const Nodes& nodes);
  /// Stays at these positions.
  void stay(const Nodes& nodes);
  const Eigen::Matrix3Xd& now() const { return now_; }
  const Eigen::Matrix3Xd& before() const { return before_; }
  /// Box of the group's nodes.
  const Box& whole(const SkinParts& parts, int group);
  const GroupBoxes& of(const SkinParts& parts, int group);
  /// [m] A gap has at most this error.
  float rounding() const { return rounding_; }

 private:
  void fill_nodes(const SkinParts& parts, std::size_t group);
  void fill(PartBoxes& boxes, std::size_t corners, const std::vector<std::uint8_t>& corner_of);

  Eigen::Matrix3Xd before_, now_;
  int origin_node_;
  Eigen::Vector3d origin_;  // [m] where coordinates are counted from
  float rounding_ = 0.0F;
  std::vector<GroupBoxes> groups_;
  std::vector<std::array<std::vector<std::uint8_t>, 3>>
      corners_;  // places of the parts' corners in the group
  std::vector<long> whole_level_, parts_level_;
  long level_ = -1;
  std::vector<Box> node_boxes_;  // of the group that was asked for last
};

/// Pairs of boxes not farther apart than `reach` [m], each with itself too; lower number first, ascending.
std::vector<std::pair<int, int>> near_boxes(const std::vector<Box>& boxes, float reach);

}  // namespace coupling::detail
