// SPDX-License-Identifier: Apache-2.0
#include "results/crossing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace driver {
namespace {

/// Nodes that an edge joins, as contact of the skin has them.
class Neighbours {
 public:
  /// Precondition: there is a triangle.
  explicit Neighbours(const TrianglesView& triangles)
      : joined_(3 * static_cast<std::size_t>(triangles.size())) {
    begin_.assign(static_cast<std::size_t>(triangles.maxCoeff()) + 2, 0);
    for (const int node : triangles.reshaped()) begin_[static_cast<std::size_t>(node) + 1] += 3;
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    auto next = begin_;
    for (Eigen::Index e = 0; e < triangles.cols(); ++e)
      for (const int a : triangles.col(e))
        for (const int b : triangles.col(e)) joined_[next[static_cast<std::size_t>(a)]++] = b;
  }
  /// True if a node of one element is one of the other, or joined to it.
  bool are(const Eigen::Vector3i& first, const Eigen::Vector3i& second) const {
    return std::ranges::any_of(first, [&](int a) {
      const auto node = static_cast<std::size_t>(a);
      return std::any_of(joined_.data() + begin_[node], joined_.data() + begin_[node + 1],
                         [&](int b) { return (second.array() == b).any(); });
    });
  }

 private:
  std::vector<std::size_t> begin_;  // in joined_, of each node's
  std::vector<int> joined_;         // nodes of the elements at each node, repeated
};

}  // namespace

Crossing find_crossing(const NodesView& nodes, const TrianglesView& triangles, bool closed,
                       std::span<const int> null_elements) {
  const auto pairs = crossing_pairs(nodes, triangles);
  Crossing crossing{.pairs = pairs.size()};
  if (pairs.empty()) return crossing;
  std::vector<char> crosses(static_cast<std::size_t>(triangles.cols()));
  const Neighbours neighbours(triangles);
  const auto is_fabric = [&](int e) { return !std::ranges::binary_search(null_elements, e); };
  for (const auto& [first, second] : pairs) {
    crosses[static_cast<std::size_t>(first)] = crosses[static_cast<std::size_t>(second)] = 1;
    if (neighbours.are(triangles.col(first), triangles.col(second))) continue;
    if (!is_fabric(first) || !is_fabric(second)) continue;
    if (crossing.layers++ == 0) crossing.first_layers = {first, second};
  }
  crossing.elements = static_cast<std::size_t>(std::ranges::count(crosses, 1));
  // One line for each element costs as much as the search of pairs.
  const int lines = static_cast<int>(std::clamp<Eigen::Index>(triangles.cols(), 2048, 16384));
  if (closed) crossing.volumes = layer_volumes(nodes, triangles, lines);
  return crossing;
}

std::string text_of(const Crossing& crossing, double volume) {
  std::string text = fmt::format("{} elements cross in {} pairs", crossing.elements, crossing.pairs);
  if (const double wrong = crossing.miscounted(); volume > 0.0 && wrong > 0.0)
    text += fmt::format(", {:.3g} of {:.3g} m3 ({:.2g} %) are counted twice or inside out", wrong, volume,
                        100.0 * wrong / volume);
  return text;
}

}  // namespace driver
