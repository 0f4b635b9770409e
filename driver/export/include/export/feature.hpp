// SPDX-License-Identifier: Apache-2.0
// How the deck of another program represents each key of a case.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/case_reader.hpp"
#include "export/deck.hpp"
#include "export/units.hpp"

namespace driver {

enum class Mapping { exact, approximated, none, left_out };
const char* name_of(Mapping mapping);

struct Outcome {
  Mapping mapping;
  const char* how;
  bool lost = false;  // an effect that the deck lacks: a case that sets it gets a note
};

/// One key of cases, without numbers of tables: "inflator.jet.radius". It includes the keys below it.
struct Feature {
  const char* key;
  Outcome radioss, lsdyna;
  const Outcome& in(DeckFormat format) const { return format == DeckFormat::radioss ? radioss : lsdyna; }
};

/// The whole table.
const std::vector<Feature>& features();
/// Its rows of impactors and what moves them.
const std::vector<Feature>& features_of_impactors();
/// Rows that take precedence for fabric by measured curves.
const std::vector<Feature>& features_of_curves();
/// True for a fabric law that the table describes.
bool is_mapped(std::string_view law);
/// Row of any other law, and of its own constants.
const Feature& feature_of_other_laws();

/// One key of the case, given or by default.
struct UsedFeature {
  std::string path;
  std::string value;
  Outcome outcome;
  bool is_default = false;
};

/// All settings of the deck's case, without parts that the deck leaves out and parts that serve only those.
/// Throws std::logic_error for a key that the table does not name.
std::vector<UsedFeature> used_features(const CaseDocument& document, const Deck& deck);

/// A note for each effect of the case that the deck lacks.
std::vector<DeckNote> notes_of_lost(const std::vector<UsedFeature>& used);

/// export.md.
std::string export_markdown(const Deck& deck, const std::vector<UsedFeature>& used, const std::string& title);

}  // namespace driver
