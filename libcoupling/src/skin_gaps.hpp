// SPDX-License-Identifier: Apache-2.0
// Gaps between the boxes of the parts of two groups, without those of neighbours.
#pragma once
#include <cstdint>
#include <vector>

#include "skin_boxes.hpp"

namespace coupling::detail {

/// Parts of two groups. Those of the lanes are in a box; each word of `mask`, if any, has the lanes that a
/// row may touch.
struct GapTable {
  const PartBoxes &rows, &lanes;
  const Box& whole;
  const std::uint64_t* mask;
};

/// Two parts by their places, whose boxes are near.
struct NearParts {
  std::uint8_t row, lane;
};

/// Returns a lower bound of the gaps [m], at most `least`; parts with a gap up to `near` go to `found`
/// instead.
float least_gap(const GapTable& table, float near, float least, std::vector<NearParts>& found);

}  // namespace coupling::detail
