// SPDX-License-Identifier: Apache-2.0
#include "edges.hpp"

#include <algorithm>
#include <cmath>

namespace mesh {

std::vector<HalfEdge> sorted_edges(const Eigen::Ref<const Eigen::Matrix3Xi>& elements) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * static_cast<std::size_t>(elements.cols()));
  for (int e = 0; e < elements.cols(); ++e)
    for (int i = 0; i < 3; ++i) {
      const int a = elements(i, e), b = elements((i + 1) % 3, e);
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b), e, i, a < b});
    }
  std::stable_sort(edges.begin(), edges.end(), [](const HalfEdge& p, const HalfEdge& q) {
    return p.low != q.low ? p.low < q.low : p.high < q.high;
  });
  return edges;
}

std::vector<EdgeGroup> edge_groups(const std::vector<HalfEdge>& edges) {
  std::vector<EdgeGroup> groups;
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && edges[end].low == edges[begin].low && edges[end].high == edges[begin].high)
      ++end;
    groups.emplace_back(&edges[begin], end - begin);
  }
  return groups;
}

bool is_flat(double volume, double area) {
  return std::abs(volume) <= 1e-12 * area * std::sqrt(area);
}

}  // namespace mesh
