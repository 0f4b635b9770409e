// SPDX-License-Identifier: Apache-2.0
// What the tables of both programs share: what a deck defines, by its numbers, in the deck's units.
#pragma once

#include "import/bag_deck.hpp"
#include "import/import_report.hpp"

namespace driver::imported {

struct DeckShell {
  long part = 0;
  std::vector<long> nodes;
  const DeckCard* card = nullptr;
  Place at;
};

/// A spring, beam or belt between two nodes.
struct DeckLink {
  long part = 0, from = 0, to = 0;
  const DeckCard* card = nullptr;
  Place at;
};

struct NumberedCurve {
  Knots knots;
  const DeckCard* card = nullptr;
};

using CurveTable = std::map<long, NumberedCurve>;
using PanelNames = std::map<long, std::string>;  // of parts of the control volume, by their numbers

inline const DeckCard* card_of(const DeckCard* card) {
  return card;
}
inline const DeckCard* card_of(const auto& entry) {
  return entry.card;
}

/// Puts an entry under its number. The card of an earlier entry is left out.
template <class Entry>
void put(std::map<long, Entry>& table, long number, Entry entry, ImportReport& report) {
  const auto earlier = table.find(number);
  if (earlier != table.end())
    report.left_out(*card_of(earlier->second), Mapping::left_out,
                    "another card with this number follows, which is taken");
  table[number] = std::move(entry);
}

/// The entry of this number. Throws DeckFault if the deck lacks it; `what` names its kind.
template <class Entry>
const Entry& entry_of(const std::map<long, Entry>& table, long number, const char* what, Place at) {
  const auto found = table.find(number);
  if (found != table.end()) return found->second;
  throw DeckFault(
      at, "names the " + std::string(what) + " " + std::to_string(number) + ", which the deck does not have");
}

/// Nodes of a deck; one that stands twice at different places is counted.
struct NodeTable {
  std::map<long, Eigen::Vector3d> places;
  int moved = 0;
  void put(long number, const Eigen::Vector3d& place);
};

/// Adds a knot. Throws DeckFault if it is before the last one.
void add_knot(NumberedCurve& curve, double x, double y, Place at);

/// The curve of this number in other units, which then became `key`. Throws DeckFault if the deck lacks it.
Knots take_curve(const CurveTable& curves, long number, double x_unit, double y_unit, const std::string& key,
                 Place at, ImportReport& report);

/// Calls read(card) for each card of a deck. A card of these kinds that cannot be read is as if it were not
/// there: what of the bag needs it is refused then. Others may be part of the bag, so they are refused.
template <class Read>
void read_tables(ImportReport& report, std::initializer_list<const char*> kinds, Read&& read) {
  report.each_card([&](const DeckCard& card) {
    try {
      read(card);
    } catch (const DeckFault& fault) {
      if (std::ranges::none_of(kinds, [&](const char* kind) { return card.keyword.starts_with(kind); }))
        throw;
      report.left_out(card, Mapping::none, std::string("is not read: ") + fault.what());
    }
  });
}

/// Takes the deck's nodes into the bag, in m.
void take_nodes(const NodeTable& nodes, double length, BagDeck& bag, ImportReport& report);

/// The cards with elements of these parts became the mesh.
void claim_shells(const std::vector<DeckShell>& shells, const PanelNames& panels, ImportReport& report);

/// A name for a part of the control volume that no other part has.
std::string panel_name(const std::string& title, long part, const PanelNames& panels);

/// Throws DeckFault if an element of the bag has a node that the deck lacks.
void require_nodes(const BagDeck& bag);

/// Nodes of the bag's elements.
std::set<long> nodes_of(const BagDeck& bag);

/// Area of a part of the control volume at the start [m2].
double area_of(const BagDeck& bag, const PanelNames& panels, long part);

}  // namespace driver::imported
