// SPDX-License-Identifier: Apache-2.0
// Nodes that lie on each other become one.
#pragma once

#include "mesh/mesh.hpp"

namespace mesh {

/// What merging did.
struct MergeReport {
  int nodes = 0;     // nodes that are gone
  int elements = 0;  // elements that are gone, because two of their corners became one
};

/// Joins each node to the first node before it that is at most `tolerance` [m] away and stays; 0 joins nodes
/// of equal coordinates. Elements with two corners in one are left out, and panels keep their numbers. The
/// order of nodes and elements stays. Throws std::invalid_argument for a tolerance that is negative or not
/// finite, for a node number out of range, and for a node that is not finite or too far away for the
/// tolerance: 2^52 times of it.
MergeReport merge_nodes(Mesh& mesh, double tolerance);

/// Joins nodes of equal coordinates that one element has, as the corners of an element without area, and
/// leaves out the elements that have a corner twice then. Nodes that lose all their elements go, too; panels
/// keep their numbers, the order of nodes and elements stays. With `start`, the nodes of a start shape, the
/// same nodes are taken from it. Returns how many elements are gone. Throws std::invalid_argument for a node
/// number out of range.
int drop_collapsed(Mesh& mesh, Eigen::Matrix3Xd* start = nullptr);

/// The mesh without the nodes that no element uses. Throws std::invalid_argument for a node number out of
/// range.
Mesh used_nodes(Mesh mesh);

}  // namespace mesh
