// SPDX-License-Identifier: Apache-2.0
// What the mappings of an LS-DYNA deck share, and the mappings.
#pragma once

#include "lsdyna_tables.hpp"

namespace driver::imported {

struct LsDynaContext {
  const DeckText& text;
  const LsDynaTables& tables;
  ImportReport& report;
  const Units& units;
  BagDeck& bag;
  const DeckCard& airbag;  // the card of the bag
  PanelNames panels{};

  /// The material of a part; nothing if the deck lacks one.
  std::optional<LsDynaEntry> material_of(long part) const;
  /// True for a rigid part; `held` says that it cannot move.
  bool is_rigid(long part, bool& held) const;

  /// A field of a card: line and number from 0, in columns of ten.
  double real(const LsDynaEntry& entry, std::size_t line, std::size_t field, const char* name) const;
  long whole(const LsDynaEntry& entry, std::size_t line, std::size_t field, const char* name) const;
  /// The curve with its units, which then became `key`. Throws DeckFault if the deck lacks it.
  Knots curve(long id, double x_unit, double y_unit, const std::string& key, Place at) const;
  /// The same of absolute pressure, over overpressure in Pa.
  Knots curve_of_pressure(long id, double y_unit, const std::string& key, Place at) const;
  std::string title_of(const DeckCard& card) const;
  /// Comment for the case: place, keyword and title of a card.
  std::string source(const DeckCard& card) const;
};

/// The control volume's shells and segments, and which parts they are of. The card's set: number and kind.
void map_volume(LsDynaContext& context, long set, bool is_part_set);
/// Nodes of rigid parts, *BOUNDARY_SPC, codes of *NODE.
void map_supports(LsDynaContext& context);
/// Springs, beams and belts, rigid walls, damping, gravity, layers that touch, end of the run.
void map_surroundings(LsDynaContext& context);
/// Materials and sections of the parts. `leak_option` is that of the airbag.
void map_fabric(LsDynaContext& context, long leak_option);
/// Gas, inflators and vents. Returns the leak option.
long map_gas(LsDynaContext& context);

/// A jet for each inflator, from the card of the cone.
void map_jet(LsDynaContext& context, const LsDynaEntry& card);

}  // namespace driver::imported
