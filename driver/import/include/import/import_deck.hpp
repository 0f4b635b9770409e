// SPDX-License-Identifier: Apache-2.0
// A deck as a bag, with a report.
#pragma once

#include <optional>

#include "import/bag_deck.hpp"
#include "import/import_report.hpp"

namespace driver::imported {

struct ImportOptions {
  std::optional<long> bag;           // number of the airbag or monitored volume; needed if there are several
  std::optional<std::string> units;  // mass-length-time, of a deck that does not state them
  bool merge_chambers = false;       // all monitored volumes of a Radioss deck are one chamber
};

/// What a deck became: a bag, and the card that it was made of. Without `card` no bag was found.
struct ImportedDeck {
  BagDeck bag;
  const DeckCard* card = nullptr;
};

/// Maps a deck; the report has the outcome of each card that something was made of, and refuses what has no
/// counterpart. `report` is of `text`.
ImportedDeck map_lsdyna(const DeckText& text, const ImportOptions& options, ImportReport& report);
ImportedDeck map_radioss(const DeckText& text, const ImportOptions& options, ImportReport& report);

/// Units such as kg-mm-ms: of mass (kg, g, t, lbm, slinch), length (m, cm, mm, in, ft) and time (s, ms, us).
/// Throws CaseError for others.
Units import_units(const std::string& name);

}  // namespace driver::imported
