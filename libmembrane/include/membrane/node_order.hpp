// SPDX-License-Identifier: Apache-2.0
// Numbering of the nodes in which a step of a large bag reads and writes memory as one stream.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "membrane/mesh.hpp"

namespace membrane {

/// Bags with more elements do not fit a core's second-level cache; they take 4 MB.
inline constexpr int kCachedElements = 20000;

/// Nodes in the order of the kernels' blocks (bag_model.hpp): own nodes block by block, then the nodes that
/// blocks share, then nodes of no element. New node i is old node result[i]; each old node occurs once.
///
/// The forces and the motion of a node have the same bits in any order of the nodes. The volume is taken
/// about the first node, and sums over nodes follow their order, so these differ by round-off. Throws
/// std::invalid_argument for a node number out of range.
std::vector<int> node_order(const Mesh& mesh);

/// The mesh with new node i in the place of old node order[i]. Elements, panels and lines keep their order.
/// Precondition: `order` has each node once.
Mesh renumbered(const Mesh& mesh, const std::vector<int>& order);

}  // namespace membrane
