// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "coupling/skin.hpp"

namespace coupling {

/// Groups of neighbouring elements that share a bound.
struct ElementGroups {
  static constexpr std::size_t kSize = 16;  // elements of a group; the last one may have fewer
  std::vector<int> elements;                // [M] element numbers; group g has [g kSize, (g + 1) kSize)
  std::vector<int> nodes;                   // nodes of the elements, group by group, each once per group
  std::vector<std::size_t> first_node;      // [groups + 1] start of each group in `nodes`
  /// Number of groups.
  std::size_t count() const { return first_node.size() - 1; }
};

/// Makes the groups of a skin with any numbering. Elements are ordered by their centroids along a Morton
/// curve through the box of `shape`, 3 x N [m].
ElementGroups make_groups(const Triangles& triangles, const Nodes& shape);

}  // namespace coupling
