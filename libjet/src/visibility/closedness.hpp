// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

namespace jet {

/// True if every directed edge occurs as often as its opposite. The surface then has an inside, and winding
/// numbers are integers.
inline bool is_closed(std::span<const std::array<int, 3>> triangles) {
  std::vector<std::pair<int, int>> edges, opposite;
  edges.reserve(3 * triangles.size());
  opposite.reserve(3 * triangles.size());
  for (const auto& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const int from = t[i], to = t[(i + 1) % 3];
      edges.emplace_back(from, to);
      opposite.emplace_back(to, from);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::sort(opposite.begin(), opposite.end());
  return edges == opposite;
}

}  // namespace jet
