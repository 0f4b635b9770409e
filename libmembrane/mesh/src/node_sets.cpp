// SPDX-License-Identifier: Apache-2.0
#include "node_sets.hpp"

#include <set>

namespace mesh {

std::vector<NodeSet> renumbered_sets(const std::vector<NodeSet>& sets,
                                     const std::function<int(int)>& number) {
  std::vector<NodeSet> result;
  for (const NodeSet& set : sets) {
    std::set<int> nodes;
    for (const int node : set.nodes)
      if (const int now = number(node); now >= 0) nodes.insert(now);
    if (!nodes.empty()) result.push_back({set.name, {nodes.begin(), nodes.end()}});
  }
  return result;
}

}  // namespace mesh
