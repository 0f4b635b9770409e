// SPDX-License-Identifier: Apache-2.0
// A deck as a case.
#pragma once

#include <memory>

#include "import/import_deck.hpp"

namespace driver::imported {

struct ImportedCase {
  DeckText text;
  ImportReport report;
  DeckFiles files;  // the case first; empty if the report refuses
  std::string scene;

  explicit ImportedCase(DeckText deck) : text(std::move(deck)), report(text) {}
  ImportedCase(const ImportedCase&) = delete;
};

/// Reads a deck. Throws CaseError if the file is no deck or the options are wrong.
std::unique_ptr<ImportedCase> import_case(const std::filesystem::path& deck, const ImportOptions& options);

/// import.json
std::string import_json(const ImportedCase& result);

}  // namespace driver::imported
