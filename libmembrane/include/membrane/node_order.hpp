// SPDX-License-Identifier: Apache-2.0
// Numbering of the nodes in which a step of a large bag reads and writes memory as one stream.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace membrane {

/// Bags with more elements (4 MB) do not fit a core's second-level cache.
inline constexpr int kCachedElements = 20000;

/// Nodes in the order of the kernels' blocks (bag_model.hpp): own nodes block by block, then the nodes that
/// blocks share, then nodes of no element. New node i is old node result[i]; each old node occurs once.
///
/// Forces and motion of a node have the same bits in any order of the nodes. The volume, taken about the
/// first node, and sums over nodes depend on the order by round-off. `elements` is 3 x M. Throws
/// std::invalid_argument for a node number out of range.
std::vector<int> node_order(const Eigen::Ref<const Eigen::Matrix3Xi>& elements, int node_count);

}  // namespace membrane
