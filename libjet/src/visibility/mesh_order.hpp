// SPDX-License-Identifier: Apache-2.0
// Order of a mesh's elements in which those that follow each other lie together, at every scale: blocks of
// eight, and blocks of these, are compact patches, so boxes around them are small.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace jet {

using Triangle = std::array<int, 3>;

/// Elements in such an order, by repeated pairing of neighbours across edges.
std::vector<int> mesh_order(std::span<const Triangle> triangles);

/// Fixed connectivity in that order, for the search of elements by their nodes.
struct OrderedMesh {
  std::vector<int> elements;     // order; the last is repeated to a multiple of eight
  std::vector<int> rank;         // place of each element in it
  int patches = 0;               // of eight elements
  std::vector<int> patch_nodes;  // of each patch, the last repeated to a multiple of four
  std::vector<int> patch_begin;  // in patch_nodes, and the end
  // Eight first, eight second, eight third corners of each patch: where the nodes' rows of four numbers
  // begin, 4 times the node.
  std::vector<std::uint32_t> corner_rows;

  explicit OrderedMesh(std::span<const Triangle> triangles);
  OrderedMesh() = default;
};

}  // namespace jet
