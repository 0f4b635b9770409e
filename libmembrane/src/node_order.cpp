// SPDX-License-Identifier: Apache-2.0
#include "membrane/node_order.hpp"

#include <algorithm>

#include "blocks.hpp"
#include "checks.hpp"
#include "membrane/bag_model.hpp"

namespace membrane {

std::vector<int> node_order(const Eigen::Ref<const Eigen::Matrix3Xi>& elements, int node_count) {
  BagModel m;
  m.node_count = node_count;
  m.element_count = static_cast<int>(elements.cols());
  m.description.elements = elements;
  std::vector<int> order;
  if (m.element_count > 0) {
    for (const int node : elements.reshaped()) require_node("node_order", "node number", node, node_count);
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

}  // namespace membrane
