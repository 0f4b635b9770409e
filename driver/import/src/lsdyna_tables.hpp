// SPDX-License-Identifier: Apache-2.0
// What an LS-DYNA deck defines, by its numbers, in the deck's units.
#pragma once

#include <set>

#include "export/units.hpp"
#include "import/bag_deck.hpp"
#include "import/deck_fields.hpp"
#include "import/import_report.hpp"

namespace driver::imported {

struct LsDynaPart {
  std::string title;
  long section = 0, material = 0;
  const DeckCard* card = nullptr;
};

struct LsDynaShell {
  long part = 0;
  std::vector<long> nodes;
  const DeckCard* card = nullptr;
  Place at;
};

/// A spring, beam or belt between two nodes.
struct LsDynaLine {
  long part = 0, from = 0, to = 0;
  const DeckCard* card = nullptr;
  Place at;
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

struct LsDynaCurve {
  Knots knots;
  const DeckCard* card = nullptr;
};

struct LsDynaTables {
  std::map<long, Eigen::Vector3d> nodes;
  std::map<long, long> held;  // constraint codes of *NODE: translations 1 to 7
  std::vector<LsDynaShell> shells;
  std::vector<LsDynaLine> springs, beams, belts;
  std::set<long> solid_nodes;  // nodes of solids
  std::map<long, long> part_of_solid_node;
  std::map<long, LsDynaPart> parts;
  std::map<long, LsDynaEntry> sections, materials, leakages;  // leakages: by material
  std::map<long, LsDynaSet> part_sets, node_sets, shell_sets, segment_sets;
  std::map<long, LsDynaCurve> curves;
};

/// Reads the deck's tables. A card that cannot be read is refused in the report.
LsDynaTables lsdyna_tables(const DeckText& text, ImportReport& report);

/// True if the keyword is `word`, perhaps with _TITLE or _ID.
bool is_keyword(const DeckCard& card, std::string_view word);
/// Number of lines before the data: 1 with _TITLE or _ID.
std::size_t head_lines(const DeckCard& card);

}  // namespace driver::imported
