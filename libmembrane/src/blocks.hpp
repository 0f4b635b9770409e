// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "membrane/bag_model.hpp"

// Division of the elements into blocks, when a model is built.
namespace membrane {

// Fills model.corners from the elements of the description.
void set_corner_table(BagModel& model);

// Fills model.elements and model.shared from the elements and the corner table. Blocks grow over neighbours,
// so they are compact and share few nodes. Of the groups it sets only the nodes; all other numbers stay 0.
void set_blocks(BagModel& model);

// Group of an element and its lane in the group.
struct ElementPlace {
  std::size_t group, lane;
};
inline ElementPlace place_of(const BlockTable& table, std::size_t element) {
  const auto place = static_cast<std::size_t>(table.place[element]);
  return {place / kLanes, place % kLanes};
}

}  // namespace membrane
