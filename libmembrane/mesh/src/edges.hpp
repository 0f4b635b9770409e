// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace mesh {

struct HalfEdge {
  int low, high;  // nodes, low < high
  int element;
  int side;      // runs from local corner `side` to `side` + 1
  bool forward;  // the element runs it from low to high
};

using EdgeGroup = std::span<const HalfEdge>;  // all half edges between the same two nodes

/// Half edges of the elements (3 x M), sorted by their nodes; those between the same two in the order of the
/// elements. An edge from a node to itself is left out.
std::vector<HalfEdge> sorted_edges(const Eigen::Ref<const Eigen::Matrix3Xi>& elements);

/// True if a surface of `area` [m2] encloses no `volume` [m3] but rounding.
bool is_flat(double volume, double area);

/// Groups of sorted `edges`, which must outlive them.
std::vector<EdgeGroup> edge_groups(const std::vector<HalfEdge>& edges);

}  // namespace mesh
