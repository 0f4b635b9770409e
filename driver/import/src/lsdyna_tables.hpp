// SPDX-License-Identifier: Apache-2.0
// What an LS-DYNA deck defines, by its numbers, in the deck's units.
#pragma once

#include "deck_tables.hpp"
#include "export/units.hpp"
#include "import/deck_fields.hpp"

namespace driver::imported {

struct LsDynaPart {
  std::string title;
  long section = 0, material = 0;
  const DeckCard* card = nullptr;
};

/// A card, and where its data begin: after a title, or the card of an identifier.
struct LsDynaEntry {
  const DeckCard* card = nullptr;
  std::size_t first = 0;
};

struct LsDynaSet {
  std::vector<long> members;
  std::vector<Facet> segments;
  const DeckCard* card = nullptr;
};

struct LsDynaTables {
  NodeTable nodes;
  std::map<long, long> held;  // constraint codes of *NODE: translations 1 to 7
  std::vector<DeckShell> shells;
  std::vector<DeckLink> springs, beams, belts;
  std::set<long> solid_nodes;  // nodes of solids
  std::map<long, long> part_of_solid_node;
  std::map<long, LsDynaPart> parts;
  std::map<long, LsDynaEntry> sections, materials, leakages;  // leakages: by material
  std::map<long, LsDynaSet> part_sets, node_sets, shell_sets, segment_sets;
  CurveTable curves;
};

/// Reads the deck's tables. A card that cannot be read is refused in the report.
LsDynaTables lsdyna_tables(ImportReport& report);

/// True if the keyword is `word`, perhaps with _TITLE or _ID.
bool is_keyword(const DeckCard& card, std::string_view word);
/// Number of lines before the data: 1 with _TITLE or _ID.
std::size_t head_lines(const DeckCard& card);

}  // namespace driver::imported
