// SPDX-License-Identifier: Apache-2.0
#include "deck_reference.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

namespace mesh {
namespace {

constexpr double kSamePlace = 1e-6;  // share of the bag's extent: precision of a deck's decimals

// Stores positions of nodes, and notes nodes that get two.
class Placing {
 public:
  Placing(DeckReference::Shape& shape, double same) : shape_(shape), same_(same) {}

  void put(DeckId node, const Eigen::Vector3d& place) {
    const auto [known, is_new] = shape_.places.try_emplace(node, place);
    if (!is_new && (known->second - place).norm() > same_) shape_.two_places = node;
  }
  bool has(DeckId node) const { return shape_.places.contains(node); }
  bool is_moved(DeckId node, const DeckPlaces& start) const {
    return has(node) && (shape_.places.at(node) - start.at(node)).norm() > same_;
  }

 private:
  DeckReference::Shape& shape_;
  double same_;
};

double extent(const DeckPlaces& places) {
  Eigen::AlignedBox3d box;
  for (const auto& [node, place] : places) box.extend(place);
  return box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
}

}  // namespace

void DeckReference::begin(DeckId part, const Eigen::Vector3d& scale, DeckId origin) {
  lists_.push_back({part, scale, origin, {}});
}

DeckReference::Shape DeckReference::shape(const std::vector<DeckShell>& shells,
                                          const DeckPlaces& start) const {
  Shape shape;
  Placing placing(shape, kSamePlace * extent(start));
  std::map<DeckId, std::set<DeckId>> nodes_of;  // nodes of each part, and of all parts (0)
  for (const DeckShell& shell : shells)
    for (const DeckCorner& corner : shell.corners)
      for (const DeckId part : {shell.part, DeckId{0}}) nodes_of[part].insert(corner.node);
  std::set<DeckId> listed;  // parts with lists
  for (const List& list : lists_) {
    if (list.nodes.empty()) continue;
    listed.insert(list.part);
    const DeckId origin = list.origin == 0 ? list.nodes.front().first : list.origin;
    const auto found = std::ranges::find(list.nodes, origin, [](const auto& entry) { return entry.first; });
    const auto of_start = start.find(origin);
    const Eigen::Vector3d centre = found != list.nodes.end() ? found->second
                                   : of_start != start.end() ? of_start->second
                                                             : Eigen::Vector3d::Zero().eval();
    for (const auto& [node, place] : list.nodes)
      if (nodes_of[list.part].contains(node))
        placing.put(node, centre + list.scale.cwiseProduct(place - centre));
  }
  for (const DeckShell& shell : shells)
    if (const auto own = shells_.find(shell.number); own != shells_.end())
      for (std::size_t i = 0; i < std::min(shell.corners.size(), own->second.size()); ++i)
        placing.put(shell.corners[i].node, start.at(own->second[i].node));
  for (const DeckShell& shell : shells) {
    if (listed.contains(0) || listed.contains(shell.part) || shells_.contains(shell.number)) continue;
    const auto any = [&](const auto& holds) { return std::ranges::any_of(shell.corners, holds); };
    if (any([&](const DeckCorner& corner) { return placing.is_moved(corner.node, start); }) &&
        any([&](const DeckCorner& corner) { return !placing.has(corner.node); }))
      shape.half = shell.part;
  }
  return shape;
}

}  // namespace mesh
