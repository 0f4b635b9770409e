// SPDX-License-Identifier: Apache-2.0
// A deck of another program as cards: keywords with their lines, each with its place, and parameters.
#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "export/deck.hpp"

namespace driver::imported {

/// Place in a deck: number of the file in DeckText::files, and line from 1.
struct Place {
  int file = 0, line = 0;
};

/// A card that cannot be read. what() says what is wrong and what is allowed, without the place.
class DeckFault : public std::runtime_error {
 public:
  DeckFault(Place at, const std::string& message) : std::runtime_error(message), at_(at) {}
  Place at() const { return at_; }

 private:
  Place at_;
};

struct DeckLine {
  std::string_view text;  // without the line's end
  Place at;
};

/// A keyword with its data lines.
struct DeckCard {
  std::string keyword;  // "*NODE", "/SURF/PART/1"; capitals
  Place at;
  std::vector<DeckLine> lines;             // data, also blank lines
  std::vector<std::string_view> comments;  // the user's own, before the data, without column headers
  bool is_long = false;                    // LS-DYNA: fields of 20 columns
};

/// A file or a line that could not be read as cards.
struct DeckLoss {
  Place at;
  std::string card, message;
};

struct DeckText {
  DeckFormat program = DeckFormat::lsdyna;
  std::vector<std::filesystem::path> files;
  std::deque<std::string> texts;  // of the files; lines refer to them
  std::vector<DeckCard> cards;    // in the order of the deck, with those of included files
  std::map<std::string, double, std::less<>> parameters;  // by names in small letters
  std::vector<DeckLoss> losses;

  /// "file:line", the file relative to the folder of the deck.
  std::string where(Place at) const;
};

/// The program by the file's ending and its first line. Throws CaseError if it is neither.
DeckFormat program_of(const std::filesystem::path& deck);

/// Reads a deck with the files that it includes. Throws FileError if the deck itself cannot be read; what
/// else is wrong is in `losses`.
DeckText read_deck_text(const std::filesystem::path& deck);

}  // namespace driver::imported
