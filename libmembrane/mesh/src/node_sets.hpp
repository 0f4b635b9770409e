// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "mesh/mesh.hpp"

namespace mesh {

/// The sets with other node numbers; nodes that are below 0 then, and sets without a node, are left out.
std::vector<NodeSet> renumbered_sets(const std::vector<NodeSet>& sets, const std::function<int(int)>& number);

}  // namespace mesh
