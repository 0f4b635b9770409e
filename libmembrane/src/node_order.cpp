// SPDX-License-Identifier: Apache-2.0
#include "membrane/node_order.hpp"

#include <algorithm>

#include "blocks.hpp"
#include "checks.hpp"
#include "membrane/bag_model.hpp"

namespace membrane {

std::vector<int> node_order(const Mesh& mesh) {
  BagModel m;
  m.node_count = mesh.node_count();
  m.element_count = mesh.element_count();
  m.description.elements = mesh.elements;
  std::vector<int> order;
  if (m.element_count > 0) {
    require_nodes("node_order", mesh.elements, m.node_count);
    set_corner_table(m);
    set_blocks(m);
  }
  std::vector<bool> placed(static_cast<std::size_t>(m.node_count), false);
  const auto place = [&](std::int32_t node) {
    if (!placed[static_cast<std::size_t>(node)]) order.push_back(node);
    placed[static_cast<std::size_t>(node)] = true;
  };
  const auto place_range = [&](std::int32_t first, std::int32_t last) {
    for (std::int32_t i = first; i < last; ++i) place(m.elements.node[static_cast<std::size_t>(i)]);
  };
  for (const ElementBlock& block : m.elements.block) place_range(block.first_node, block.first_shared);
  for (const ElementBlock& block : m.elements.block) place_range(block.first_shared, block.last_node);
  for (std::int32_t node = 0; node < m.node_count; ++node) place(node);
  return order;
}

Mesh renumbered(const Mesh& mesh, const std::vector<int>& order) {
  std::vector<int> place(order.size());
  Mesh result = mesh;
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
    result.nodes.col(static_cast<Eigen::Index>(i)) = mesh.nodes.col(order[i]);
    if (mesh.start) result.start->col(static_cast<Eigen::Index>(i)) = mesh.start->col(order[i]);
  }
  for (int& node : result.elements.reshaped()) node = place[static_cast<std::size_t>(node)];
  return result;
}

}  // namespace membrane
