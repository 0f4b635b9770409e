// SPDX-License-Identifier: Apache-2.0
// What the writers of both formats ask a deck: numbers of nodes, elements and parts.
#pragma once

#include <array>
#include <vector>

#include "export/deck.hpp"

namespace driver {

/// Numbers of what both decks have besides the bag, whose nodes and elements begin at 1.
struct DeckIds {
  explicit DeckIds(const Deck& deck);
  int sphere_node = 0, cg = 0, pivot = 0, along = 0, across = 0, support = 0;  // nodes; sphere: the first
  int sphere_element = 0, strap_element = 0, joint_element = 0;                // the first of each
  int sphere_part = 0, strap_part = 0, joint_part = 0;                         // straps: the first
};

/// Numbers of the bag's nodes, from 1; without the fixed ones if asked for.
std::vector<int> bag_nodes(const Deck& deck, bool free_only);
/// Nodes that are held along the same axes.
struct HeldNodes {
  std::array<bool, 3> along{};  // x, y, z; fixed nodes: all
  std::vector<int> nodes;       // their numbers, from 1
  bool fixed() const { return along[0] && along[1] && along[2]; }
};
/// All of them, each node once.
std::vector<HeldNodes> held_nodes(const Deck& deck);
std::vector<int> sphere_nodes(const Deck& deck, const DeckIds& ids);
/// Numbers of the corners of elements of the bag, rising.
std::vector<int> corners_of(const Deck& deck, const std::vector<int>& elements);

/// The fabric of the first part that has one; null panels borrow its thickness and modulus.
const membrane::ElementProperties& a_fabric(const Deck& deck);
/// Force of a strap [N] against its elongation from the start [m]. The knots are even about the kink, so that
/// programs that read curves again on a hundred even steps have a knot there.
DeckCurve force_of(const Deck& deck, const membrane::Strap& strap);

}  // namespace driver
