// SPDX-License-Identifier: Apache-2.0
#include "skin_gaps.hpp"

#include <algorithm>
#include <limits>

#include "skin_lanes.hpp"

namespace coupling::detail {
namespace {

// Infinite where a bit of four is not set, else as low as can be.
constexpr auto kExcluded = [] {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  std::array<std::array<float, 4>, 16> table{};
  for (std::size_t bits = 0; bits < 16; ++bits)
    for (std::size_t k = 0; k < 4; ++k) table[bits][k] = (bits >> k) & 1 ? -infinity : infinity;
  return table;
}();

// Adds the gaps of four lanes from `begin` on: those up to `near` to `found`, of others the least to `least`.
void add_gaps(Four gaps, float near, std::size_t row, std::size_t begin, float& least,
              std::vector<NearParts>& found) {
  for (std::size_t k = 0; k < 4; ++k)
    if (gaps[k] > near)
      least = std::min(least, gaps[k]);
    else
      found.push_back({static_cast<std::uint8_t>(row), static_cast<std::uint8_t>(begin + k)});
}

// Gaps along the axes of parts and a box; no group has more parts of a kind than corners.
std::array<float, 3 * ElementGroups::kSize> gaps_to(const PartBoxes& parts, const Box& box) {
  std::array<float, 3 * ElementGroups::kSize> gaps;
  for (std::size_t i = 0; i < parts.count; i += 4) {
    Four gap = load(kExcluded[15].data());
    for (std::size_t d = 0; d < 3; ++d)
      gap = larger(gap, larger(load(parts.low.data() + d * parts.stride + i) - box.high[d],
                               box.low[d] - load(parts.high.data() + d * parts.stride + i)));
    store(gaps.data() + i, gap);
  }
  return gaps;
}

}  // namespace

float least_gap(const GapTable& table, float near, float least, std::vector<NearParts>& found) {
  const auto &rows = table.rows, &lanes = table.lanes;
  const std::size_t rs = rows.stride, ls = lanes.stride;
  const auto apart = gaps_to(rows, table.whole);
  for (std::size_t i = 0; i < rows.count; ++i) {
    const float *row_low = rows.low.data() + i, *row_high = rows.high.data() + i;
    if (apart[i] > std::max(near, least)) continue;
    const std::uint64_t allowed = table.mask ? table.mask[i] : ~std::uint64_t{0};
    for (std::size_t begin = 0; begin < lanes.count; begin += kLanes) {
      const std::size_t bits = (allowed >> begin) & 255;
      if (bits == 0) continue;
      Four a = load(kExcluded[bits & 15].data()), b = load(kExcluded[bits >> 4].data());
      const float *low = lanes.low.data() + begin, *high = lanes.high.data() + begin;
      const auto widen = [&](std::size_t from, std::size_t to) {
        for (std::size_t d = from; d < to; ++d) {
          const float l = row_low[d * rs], h = row_high[d * rs];
          const Four lows = {l, l, l, l}, highs = {h, h, h, h};
          a = larger(a, larger(lows - load(high + d * ls), load(low + d * ls) - highs));
          b = larger(b, larger(lows - load(high + d * ls + 4), load(low + d * ls + 4) - highs));
        }
        return least_of(smaller(a, b));
      };
      // Most parts are farther apart along an axis than others are at all.
      if (widen(0, 3) > std::max(near, least)) continue;
      const float smallest = widen(3, kDirections);
      if (smallest > near) {
        least = std::min(least, smallest);
      } else {
        add_gaps(a, near, i, begin, least, found);
        add_gaps(b, near, i, begin + 4, least, found);
      }
    }
  }
  return least;
}

}  // namespace coupling::detail
