// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace mesh {

struct HalfEdge {
  int low, high;  // nodes, low < high
  int element;
  int side;      // from local corner `side` to `side` + 1
  bool forward;  // true: the element passes it from low to high
};

using EdgeGroup = std::span<const HalfEdge>;  // all half edges between the same two nodes

/// Half edges of the elements (3 x M), sorted by their nodes, then by element. An edge from a node to itself
/// is left out.
std::vector<HalfEdge> sorted_edges(const Eigen::Ref<const Eigen::Matrix3Xi>& elements);

/// True if the `volume` [m3] of a surface of `area` [m2] is only rounding.
bool is_flat(double volume, double area);

/// Groups of sorted `edges`, which must outlive the groups.
std::vector<EdgeGroup> edge_groups(const std::vector<HalfEdge>& edges);

}  // namespace mesh
