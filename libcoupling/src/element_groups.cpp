// SPDX-License-Identifier: Apache-2.0
#include "coupling/element_groups.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace coupling {
namespace {

// Interleaves the bits of the three coordinates `steps`, each below 2^20.
std::uint64_t morton_code(const Eigen::Array3d& steps) {
  std::uint64_t code = 0;
  for (int bit = 19; bit >= 0; --bit)
    for (int i = 0; i < 3; ++i) code = 2 * code + ((static_cast<std::uint64_t>(steps[i]) >> bit) & 1);
  return code;
}

std::vector<int> in_morton_order(const Triangles& triangles, const Nodes& shape) {
  const Eigen::Array3d low = shape.rowwise().minCoeff(), high = shape.rowwise().maxCoeff();
  // Scaled by the longest side, so that the groups of a flat skin are round.
  const double scale = 0x1p20 * (1.0 - 1e-9) / (high - low).maxCoeff();
  std::vector<std::uint64_t> code;
  for (Eigen::Index e = 0; e < triangles.cols(); ++e) {
    const Eigen::Array3d sum =
        shape.col(triangles(0, e)) + shape.col(triangles(1, e)) + shape.col(triangles(2, e));
    code.push_back(morton_code((sum / 3.0 - low).max(0.0) * scale));
  }
  std::vector<int> order(code.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return code[static_cast<std::size_t>(a)] < code[static_cast<std::size_t>(b)];
  });
  return order;
}

}  // namespace

ElementGroups make_groups(const Triangles& triangles, const Nodes& shape) {
  ElementGroups groups{in_morton_order(triangles, shape), {}, {0}};
  for (std::size_t first = 0; first < groups.elements.size(); first += ElementGroups::kSize) {
    const std::size_t last = std::min(first + ElementGroups::kSize, groups.elements.size());
    std::vector<int> corners;
    for (std::size_t k = first; k < last; ++k)
      for (const int node : triangles.col(groups.elements[k])) corners.push_back(node);
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    groups.nodes.insert(groups.nodes.end(), corners.begin(), corners.end());
    groups.first_node.push_back(groups.nodes.size());
  }
  return groups;
}

}  // namespace coupling
