// SPDX-License-Identifier: Apache-2.0
#include "skin_gaps.hpp"

#include <algorithm>
#include <limits>

namespace coupling::detail {
namespace {

using Lanes = std::array<float, kLanes>;

// Infinite where a bit of the byte is not set, else as low as can be.
constexpr auto kExcluded = [] {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  std::array<Lanes, 256> table{};
  for (std::size_t byte = 0; byte < 256; ++byte)
    for (std::size_t k = 0; k < kLanes; ++k) table[byte][k] = (byte >> k) & 1 ? -infinity : infinity;
  return table;
}();

}  // namespace

float least_gap(const GapTable& table, float near, float least, std::vector<NearParts>& found) {
  const auto &rows = table.rows, &lanes = table.lanes;
  const std::size_t row_stride = rows.stride, lane_stride = lanes.stride;
  for (std::size_t i = 0; i < rows.count; ++i) {
    const std::uint64_t allowed = table.mask ? table.mask[i] : ~std::uint64_t{0};
    for (std::size_t begin = 0; begin < lanes.count; begin += kLanes) {
      const std::uint64_t byte = (allowed >> begin) & 255;
      if (byte == 0) continue;
      Lanes gap = kExcluded[byte];
      for (std::size_t d = 0; d < kDirections; ++d) {
        const float low = rows.low[d * row_stride + i], high = rows.high[d * row_stride + i];
        const float* const lane_low = &lanes.low[d * lane_stride + begin];
        const float* const lane_high = &lanes.high[d * lane_stride + begin];
        for (std::size_t k = 0; k < kLanes; ++k) {
          gap[k] = std::max(gap[k], low - lane_high[k]);
          gap[k] = std::max(gap[k], lane_low[k] - high);
        }
      }
      float smallest = gap[0];
      for (std::size_t k = 1; k < kLanes; ++k) smallest = std::min(smallest, gap[k]);
      if (smallest > near) {
        least = std::min(least, smallest);
        continue;
      }
      for (std::size_t k = 0; k < kLanes; ++k)
        if (gap[k] > near)
          least = std::min(least, gap[k]);
        else
          found.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(begin + k)});
    }
  }
  return least;
}

}  // namespace coupling::detail
