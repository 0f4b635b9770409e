// SPDX-License-Identifier: Apache-2.0
#include "results/crossing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace driver {
namespace {

bool share_a_node(const Eigen::Vector3i& a, const Eigen::Vector3i& b) {
  return (a.array() == b[0] || a.array() == b[1] || a.array() == b[2]).any();
}

}  // namespace

Crossing find_crossing(const NodesView& nodes, const TrianglesView& triangles, bool closed,
                       std::span<const int> null_elements) {
  const auto pairs = crossing_pairs(nodes, triangles);
  Crossing crossing{.pairs = pairs.size()};
  if (pairs.empty()) return crossing;
  std::vector<char> crosses(static_cast<std::size_t>(triangles.cols()));
  const auto is_fabric = [&](int e) { return !std::ranges::binary_search(null_elements, e); };
  for (const auto& [first, second] : pairs) {
    crosses[static_cast<std::size_t>(first)] = crosses[static_cast<std::size_t>(second)] = 1;
    if (share_a_node(triangles.col(first), triangles.col(second))) continue;
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
