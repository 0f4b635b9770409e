// SPDX-License-Identifier: Apache-2.0
// Boxes of the paths of a skin's parts in the last step and on the way ahead, by groups.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "skin_box.hpp"
#include "skin_motion.hpp"
#include "skin_parts.hpp"

namespace coupling::detail {

inline constexpr std::size_t kLanes = 8;  // parts whose boxes are compared at once

/// Boxes of the parts of one kind of a group, and none up to a multiple of the lanes.
struct PartBoxes {
  std::size_t count = 0, stride = 0;
  std::vector<float> low, high;  // [direction * stride + part]
};

struct GroupBoxes {
  Box whole;
  PartBoxes nodes, edges, elements;  // in their order in the group
};

/// The boxes of all groups; each is worked out when it is first asked for.
class SkinBoxes {
 public:
  explicit SkinBoxes(const SkinParts& parts);

  /// Forgets all boxes.
  void forget() { ++level_; }
  const GroupBoxes& of(int group, const SkinMotion& motion);

 private:
  std::vector<GroupBoxes> groups_;
  std::vector<long> known_;  // at that level
  long level_ = 0;
  std::vector<std::array<std::vector<int>, 3>> corners_;  // (groups) of nodes, edges and elements
};

}  // namespace coupling::detail
