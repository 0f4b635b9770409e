// SPDX-License-Identifier: Apache-2.0
// Order of a mesh's elements in which successive elements are close together at every scale. Blocks of eight,
// and blocks of eight such blocks, are compact patches with small boxes.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace jet {

using Triangle = std::array<int, 3>;

/// Finds such an order by repeated pairing of neighbours across edges.
std::vector<int> mesh_order(std::span<const Triangle> triangles);

/// Connectivity in that order, for the search of elements by their nodes.
struct OrderedMesh {
  std::vector<int> elements;     // in order; the last one repeated to a multiple of eight
  std::vector<int> rank;         // place of each element in the order
  int patches = 0;               // patches of eight elements
  std::vector<int> patch_nodes;  // nodes of each patch, the last one repeated to a multiple of four
  std::vector<int> patch_begin;  // start of each patch in patch_nodes, and the end
  // Corners of each patch: eight first, eight second, eight third corners, as the begin of the node's row, 4
  // times the node.
  std::vector<std::uint32_t> corner_rows;

  explicit OrderedMesh(std::span<const Triangle> triangles);
  OrderedMesh() = default;

  /// Number of the element at a place in the order.
  int element(int place) const { return elements[static_cast<std::size_t>(place)]; }
};

}  // namespace jet
