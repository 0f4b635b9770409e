// SPDX-License-Identifier: Apache-2.0
// Boxes and parts of a skin that are near each other.
#pragma once
#include <limits>
#include <utility>
#include <vector>

#include "skin_search.hpp"

namespace coupling::detail {

inline constexpr double kEverywhere = std::numeric_limits<double>::infinity();

GroupBox box_of_group(const ElementGroups& groups, int group, const Nodes& nodes, long level);

/// Distance of two boxes [m], rounded down.
double gap_of(const GroupBox& a, const GroupBox& b);

/// Pairs of boxes closer than `reach` [m], each with itself too; lower number first, ascending.
std::vector<std::pair<int, int>> near_boxes(const std::vector<GroupBox>& boxes, double reach);

/// Adds to `list` the parts of two groups that may touch within `pad` [m], which do not have a node in
/// common; `free` is their distance less the reach of their kind. Everywhere: all of them, and boxes are not
/// read.
struct ListMaker {
  const SkinParts& parts;
  const Nodes& nodes;
  double pad;
  std::vector<Listed>& list;

  /// Nodes of the first group with triangles of the second.
  void add_nodes(int first, const GroupBox& first_box, int second, const GroupBox& second_box) const;
  /// Edges of both; of one group each pair once.
  void add_edges(int first, const GroupBox& first_box, int second, const GroupBox& second_box) const;

 private:
  void add(const PartPair& pair) const;
};

}  // namespace coupling::detail
