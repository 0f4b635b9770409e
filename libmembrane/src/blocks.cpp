// SPDX-License-Identifier: Apache-2.0
#include "blocks.hpp"

#include <algorithm>

namespace membrane {

namespace {

std::size_t at(std::int32_t index) {
  return static_cast<std::size_t>(index);
}

// Grows blocks one after the other, each breadth-first over neighbours from an element beside earlier blocks.
class Growth {
 public:
  explicit Growth(const BagModel& model)
      : model_(model),
        block_of_element_(at(model.element_count), -1),
        block_of_node_(at(model.node_count), -1),
        queued_in_(at(model.element_count), -1) {}

  // Elements of each block, ascending.
  std::vector<std::vector<std::int32_t>> blocks() {
    std::vector<std::vector<std::int32_t>> result;
    while (next_unassigned() < model_.element_count) {
      result.push_back(grow(static_cast<std::int32_t>(result.size())));
      std::sort(result.back().begin(), result.back().end());
    }
    return result;
  }

 private:
  std::int32_t next_unassigned() {
    while (next_ < model_.element_count && block_of_element_[at(next_)] >= 0) ++next_;
    return next_;
  }

  // An element where the last block stopped, or the first element left.
  std::int32_t seed() {
    for (; front_ < queue_.size(); ++front_)
      if (block_of_element_[at(queue_[front_])] < 0) return queue_[front_];
    return next_unassigned();
  }

  std::vector<std::int32_t> grow(std::int32_t block) {
    std::vector<std::int32_t> elements;
    int nodes = 0;
    while (elements.size() < kBlockElements) {
      const std::int32_t start = seed();
      if (start == model_.element_count) return elements;
      queue_.assign(1, start);
      for (front_ = 0; front_ < queue_.size() && elements.size() < kBlockElements; ++front_) {
        if (block_of_element_[at(queue_[front_])] >= 0) continue;
        if (nodes + new_nodes(queue_[front_], block) > kBlockNodes) return elements;
        nodes += add(queue_[front_], block);
        elements.push_back(queue_[front_]);
      }
    }
    return elements;
  }

  int new_nodes(std::int32_t element, std::int32_t block) const {
    int count = 0;
    for (const int node : model_.description.elements.col(element))
      count += block_of_node_[at(node)] != block;
    return count;
  }

  // Adds the element, queues its neighbours and returns the number of its nodes that are new to the block.
  int add(std::int32_t element, std::int32_t block) {
    const int count = new_nodes(element, block);
    block_of_element_[at(element)] = block;
    const CornerTable& corners = model_.corners;
    for (const int node : model_.description.elements.col(element)) {
      block_of_node_[at(node)] = block;
      for (auto k = corners.row_begin[at(node)]; k < corners.row_begin[at(node) + 1]; ++k) {
        const std::int32_t neighbour = corners.element[at(k)];
        if (block_of_element_[at(neighbour)] >= 0 || queued_in_[at(neighbour)] == block) continue;
        queued_in_[at(neighbour)] = block;
        queue_.push_back(neighbour);
      }
    }
    return count;
  }

  const BagModel& model_;
  std::vector<std::int32_t> block_of_element_, block_of_node_, queued_in_, queue_;
  std::size_t front_ = 0;
  std::int32_t next_ = 0;
};

// Nodes of a block, ascending.
std::vector<std::int32_t> nodes_of(const BagModel& m, const std::vector<std::int32_t>& elements) {
  std::vector<std::int32_t> nodes;
  for (const std::int32_t e : elements)
    for (const int node : m.description.elements.col(e)) nodes.push_back(node);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

// Appends the groups of one block; `place_in_block` of its nodes is set. Each lane has a quarter of the
// elements, so that elements of a group share few nodes: additions to one node's sum wait for each other,
// which took a seventh of a step if neighbours shared a group.
void append_groups(BagModel& m, const std::vector<std::int32_t>& elements,
                   const std::vector<std::uint16_t>& place_in_block) {
  BlockTable& table = m.elements;
  const std::size_t first = table.group.size(), count = (elements.size() + kLanes - 1) / kLanes;
  table.group.resize(first + count);
  table.element.resize(kLanes * (first + count), -1);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const std::size_t group = first + i % count, lane = i / count;
    table.element[kLanes * group + lane] = elements[i];
    table.place[at(elements[i])] = static_cast<std::int32_t>(kLanes * group + lane);
    for (int corner = 0; corner < 3; ++corner)
      table.group[group].node[corner][lane] = place_in_block[at(m.description.elements(corner, elements[i]))];
  }
}

void append_block(BagModel& m, const std::vector<std::int32_t>& elements, std::vector<std::int32_t> nodes,
                  const std::vector<int>& holders, std::vector<std::uint16_t>& place_in_block) {
  BlockTable& table = m.elements;
  const auto shared = std::stable_partition(nodes.begin(), nodes.end(),
                                            [&](std::int32_t node) { return holders[at(node)] == 1; });
  ElementBlock block{};
  block.first_group = static_cast<std::int32_t>(table.group.size());
  block.first_node = static_cast<std::int32_t>(table.node.size());
  block.first_shared = block.first_node + static_cast<std::int32_t>(shared - nodes.begin());
  block.last_node = block.first_node + static_cast<std::int32_t>(nodes.size());
  if (!table.block.empty()) {
    const ElementBlock& before = table.block.back();
    block.first_slot = before.first_slot + before.last_node - before.first_shared;
  }
  table.node.insert(table.node.end(), nodes.begin(), nodes.end());
  for (std::size_t n = 0; n < nodes.size(); ++n) place_in_block[at(nodes[n])] = static_cast<std::uint16_t>(n);
  append_groups(m, elements, place_in_block);
  block.last_group = static_cast<std::int32_t>(table.group.size());
  table.block.push_back(block);
}

void set_shared_nodes(BagModel& m, const std::vector<int>& holders) {
  std::vector<std::int32_t> row(holders.size(), -1);
  m.shared.row_begin.assign(1, 0);
  for (std::int32_t node = 0; node < m.node_count; ++node) {
    if (holders[at(node)] < 2) continue;
    row[at(node)] = static_cast<std::int32_t>(m.shared.node.size());
    m.shared.node.push_back(node);
    m.shared.row_begin.push_back(m.shared.row_begin.back() + holders[at(node)]);
  }
  m.shared.slot.resize(at(m.shared.row_begin.back()));
  auto next = m.shared.row_begin;
  for (const ElementBlock& block : m.elements.block)
    for (std::int32_t i = block.first_shared; i < block.last_node; ++i)
      m.shared.slot[at(next[at(row[at(m.elements.node[at(i)])])]++)] =
          block.first_slot + (i - block.first_shared);
}

}  // namespace

void set_corner_table(BagModel& m) {
  CornerTable& table = m.corners;
  const Eigen::Matrix3Xi& elements = m.description.elements;
  table.row_begin.assign(at(m.node_count) + 1, 0);
  for (const int node : elements.reshaped()) ++table.row_begin[at(node) + 1];
  for (std::size_t n = 1; n < table.row_begin.size(); ++n) table.row_begin[n] += table.row_begin[n - 1];
  table.element.resize(static_cast<std::size_t>(elements.size()));
  auto next = table.row_begin;
  for (std::int32_t e = 0; e < m.element_count; ++e)
    for (const int node : elements.col(e)) table.element[at(next[at(node)]++)] = e;
}

void set_blocks(BagModel& m) {
  const auto blocks = Growth(m).blocks();
  std::vector<std::vector<std::int32_t>> nodes;
  std::vector<int> holders(at(m.node_count), 0);  // number of blocks with the node
  for (const auto& elements : blocks) {
    nodes.push_back(nodes_of(m, elements));
    for (const std::int32_t node : nodes.back()) ++holders[at(node)];
  }
  m.elements.place.resize(at(m.element_count));
  std::vector<std::uint16_t> place_in_block(at(m.node_count));
  for (std::size_t b = 0; b < blocks.size(); ++b)
    append_block(m, blocks[b], std::move(nodes[b]), holders, place_in_block);
  set_shared_nodes(m, holders);
}

}  // namespace membrane
