// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "coupling/skin.hpp"

namespace coupling {

// Groups of neighbouring elements, for bounds that many elements share.
struct ElementGroups {
  static constexpr std::size_t kSize = 16;  // elements of a group, but the last
  std::vector<int> elements;                // (M) numbers; group g holds [g kSize, (g + 1) kSize)
  std::vector<int> nodes;                   // corners of one group after the other, each once in each
  std::vector<std::size_t> first_node;      // (groups + 1) where a group's begin in `nodes`
  // Number of groups.
  std::size_t count() const { return first_node.size() - 1; }
};

// Groups of a skin whose numbering may be any: elements in the order of their centroids along a Morton curve
// through the box of the shape (3 x N) [m].
ElementGroups make_groups(const Triangles& triangles, const Nodes& shape);

}  // namespace coupling
