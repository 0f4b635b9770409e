// SPDX-License-Identifier: Apache-2.0
// What a Radioss starter deck defines, by its numbers, in the deck's units.
#pragma once

#include "deck_tables.hpp"
#include "export/units.hpp"
#include "import/deck_fields.hpp"

namespace driver::imported {

struct RadiossPart {
  std::string title;
  long property = 0, material = 0, subset = 0;
  const DeckCard* card = nullptr;
};

/// Words of a keyword between slashes: /MAT/GAS/MASS/4 has four.
std::vector<std::string> words_of(const DeckCard& card);
/// The number at the end of a keyword; 0 if it has none.
long number_of(const DeckCard& card);

struct RadiossTables {
  NodeTable nodes;
  std::vector<DeckShell> shells;
  std::vector<DeckLink> springs;
  std::map<long, RadiossPart> parts;
  std::map<long, const DeckCard*> materials, properties, leaks, surfaces, groups, sensors, subsets;
  CurveTable curves;
};

/// Reads the deck's tables. A card that cannot be read is refused in the report.
RadiossTables radioss_tables(ImportReport& report);

/// Members of a surface.
struct RadiossSurface {
  std::set<long> parts;
  std::vector<Facet> segments;
};

struct RadiossContext {
  const DeckText& text;
  const RadiossTables& tables;
  ImportReport& report;
  const Units& units;
  BagDeck& bag;
  const DeckCard& volume;         // the monitored volume
  PanelNames panels{};            // parts of the surface, by their numbers
  bool chambers_are_one = false;  // volumes that exchange gas are one

  DeckFields tens(const DeckCard& card, std::size_t line) const;      // ten fields of ten columns
  DeckFields twenties(const DeckCard& card, std::size_t line) const;  // five fields of twenty columns
  Knots curve(long id, double x_unit, double y_unit, const std::string& key, Place at) const;
  std::string source(const DeckCard& card) const;
  /// Members of sets, those of sets of sets included. Throw DeckFault for a kind that is not read, and for
  /// sets that have each other as members.
  RadiossSurface surface(long number, Place at, int depth = 0) const;
  std::set<long> nodes_of_group(long group, Place at, int depth = 0) const;
};

void map_surface(RadiossContext& context);
void map_gas(RadiossContext& context);
void map_openings(RadiossContext& context, std::size_t first_line);
void map_fabric(RadiossContext& context);
void map_surroundings(RadiossContext& context);

}  // namespace driver::imported
