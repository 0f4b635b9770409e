// SPDX-License-Identifier: Apache-2.0
#include "export/deck_ids.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <numeric>
#include <set>

namespace driver {

DeckIds::DeckIds(const Deck& deck) {
  const mesh::Mesh& mesh = deck.scene->bag->mesh;
  const int straps = static_cast<int>(deck.scene->bag->model.description.straps.size());
  const int panels = static_cast<int>(mesh.panel_names.size());
  const int surface_nodes = deck.impactor ? deck.impactor->surface.node_count() : 0;
  const int surface_elements = deck.impactor ? deck.impactor->surface.element_count() : 0;
  impactor_node = mesh.node_count() + 1;
  cg = impactor_node + surface_nodes;
  pivot = cg + 1;
  along = cg + 2;
  centre = cg + 3;
  support = cg + 4;  // and three more
  strap_element = mesh.element_count() + 1;
  impactor_element = strap_element + straps;
  carrier_element = impactor_element + surface_elements;
  strap_part = panels + 1;
  impactor_part = strap_part + straps;
  carrier_part = impactor_part + 1;
}

std::vector<HeldNodes> held_nodes(const Deck& deck) {
  const auto inverse_mass = deck.scene->bag->model.inverse_mass.map();
  std::map<std::array<bool, 3>, std::vector<int>, std::greater<>> held;
  for (int n = 0; n < deck.scene->bag->mesh.node_count(); ++n) {
    const auto at = [&](int axis) { return inverse_mass(axis, n) == 0.0; };
    if (at(0) || at(1) || at(2)) held[{at(0), at(1), at(2)}].push_back(n + 1);
  }
  std::vector<HeldNodes> list;
  for (const auto& [along, nodes] : held) list.push_back({along, nodes});
  return list;
}

std::vector<int> bag_nodes(const Deck& deck, bool free_only) {
  std::vector<int> nodes(static_cast<std::size_t>(deck.scene->bag->mesh.node_count()));
  std::iota(nodes.begin(), nodes.end(), 1);
  if (!free_only) return nodes;
  const auto held = held_nodes(deck);
  const auto fixed = std::ranges::find_if(held, &HeldNodes::fixed);
  if (fixed == held.end()) return nodes;
  std::vector<int> free;
  std::ranges::set_difference(nodes, fixed->nodes, std::back_inserter(free));
  return free;
}

std::vector<int> impactor_nodes(const Deck& deck, const DeckIds& ids) {
  std::vector<int> nodes(static_cast<std::size_t>(deck.impactor->surface.node_count()));
  std::iota(nodes.begin(), nodes.end(), ids.impactor_node);
  return nodes;
}

std::vector<int> corners_of(const Deck& deck, const std::vector<int>& elements) {
  std::set<int> corners;
  for (const int e : elements)
    for (int i = 0; i < 3; ++i) corners.insert(deck.scene->bag->mesh.elements(i, e) + 1);
  return {corners.begin(), corners.end()};
}

const membrane::ElementProperties& a_fabric(const Deck& deck) {
  return std::ranges::find(deck.parts, false, &DeckPart::null_panel)->fabric;
}

DeckCurve force_of(const Deck& deck, const membrane::Strap& strap) {
  const auto& start = deck.scene->bag->initial_position;
  const double slack = strap.free_length - (start.col(strap.node_a) - start.col(strap.node_b)).norm();
  return {{slack - 1.0, 0.0}, {slack, 0.0}, {slack + 1.0, strap.stiffness}};
}

}  // namespace driver
