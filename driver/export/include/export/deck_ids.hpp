// SPDX-License-Identifier: Apache-2.0
// Numbers of nodes, elements and parts of a deck, for the writers of both formats.
#pragma once

#include <array>
#include <vector>

#include "export/deck.hpp"

namespace driver {

/// Numbers of the objects that both decks have besides the bag. The bag's nodes and elements begin at 1.
struct DeckIds {
  explicit DeckIds(const Deck& deck);
  // Nodes: the first one of the impactor's surface, its centre of gravity, and a node of it at its centre;
  // two of a pendulum on its axis; the first one of what does not move.
  int impactor_node = 0, cg = 0, centre = 0, pivot = 0, along = 0, support = 0;
  // The first element of each, and part; carrier: joint of a pendulum, or springs of a rail.
  int impactor_element = 0, strap_element = 0, carrier_element = 0;
  int impactor_part = 0, strap_part = 0, carrier_part = 0;
};

/// Numbers of the bag's nodes, from 1; with `free_only`, without the fixed ones.
std::vector<int> bag_nodes(const Deck& deck, bool free_only);
/// Nodes that are held along the same axes.
struct HeldNodes {
  std::array<bool, 3> along{};  // x, y, z; fixed nodes: all
  std::vector<int> nodes;       // their numbers, from 1
  bool fixed() const { return along[0] && along[1] && along[2]; }
};
/// All held nodes, each once.
std::vector<HeldNodes> held_nodes(const Deck& deck);
/// Numbers of the nodes of the impactor's surface.
std::vector<int> impactor_nodes(const Deck& deck, const DeckIds& ids);
/// Numbers of the nodes of elements of the bag, rising.
std::vector<int> corners_of(const Deck& deck, const std::vector<int>& elements);

/// The fabric of the first part that has one. Null panels use its thickness and modulus.
const membrane::ElementProperties& a_fabric(const Deck& deck);
/// Force of a strap [N] against its elongation from the start [m]. Knots are evenly spaced about the kink, so
/// that programs that resample curves on a hundred even steps have a knot there.
DeckCurve force_of(const Deck& deck, const membrane::Strap& strap);

}  // namespace driver
