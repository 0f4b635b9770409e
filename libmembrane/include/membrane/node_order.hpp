// SPDX-License-Identifier: Apache-2.0
// Numbering of the nodes by which a step of a large bag reads and writes memory in one stream.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "membrane/mesh.hpp"

namespace membrane {

/// Bags of more elements than this leave a core's second-level cache: 4 MB.
inline constexpr int kCachedElements = 20000;

/// The nodes block by block of the kernels (bag_model.hpp), those that blocks share after all others: new
/// node i is the old node result[i], each once. Nodes of no element come last. Forces and motion of a node
/// are the same bits in any order of the nodes; the volume is taken about the first one, and sums over nodes
/// go by their order, to round-off. Throws std::invalid_argument for a node number out of range.
std::vector<int> node_order(const Mesh& mesh);

/// The mesh with new node i at the place of the old node order[i]. Elements, panels and lines keep their
/// order. Precondition: `order` has each node once.
Mesh renumbered(const Mesh& mesh, const std::vector<int>& order);

}  // namespace membrane
