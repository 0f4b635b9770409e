// SPDX-License-Identifier: Apache-2.0
// Merges nodes that lie on each other.
#pragma once

#include "mesh/mesh.hpp"

namespace mesh {

/// Result of merging.
struct MergeReport {
  int nodes = 0;     // nodes removed
  int elements = 0;  // elements removed because two of their corners became one
};

/// Joins each node to the first remaining node before it within `tolerance` [m]; 0 joins nodes of equal
/// coordinates. Elements with two equal corners are removed; panels keep their numbers, nodes and elements
/// their order. Throws std::invalid_argument for a tolerance that is negative or not finite, a node number
/// out of range, and a node that is not finite or whose coordinates exceed 2^52 tolerances.
MergeReport merge_nodes(Mesh& mesh, double tolerance);

/// Joins nodes of equal coordinates within one element, and removes elements that then have a corner twice,
/// and nodes that lose all their elements. Panels keep their numbers, nodes and elements their order. With
/// `start`, the nodes of a start shape, the same nodes are removed from it. Returns the number of elements
/// removed. Throws std::invalid_argument for a node number out of range.
int drop_collapsed(Mesh& mesh, Eigen::Matrix3Xd* start = nullptr);

/// The mesh without the nodes that no element uses. Throws std::invalid_argument for a node number out of
/// range.
Mesh used_nodes(Mesh mesh);

}  // namespace mesh
