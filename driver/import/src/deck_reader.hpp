// SPDX-License-Identifier: Apache-2.0
// What the readers of both programs share: files that include others.
#pragma once

#include <functional>

#include "import/deck_text.hpp"

namespace driver::imported {

/// Reads files into a DeckText, each as lines.
class DeckReader {
 public:
  explicit DeckReader(DeckText& deck) : deck_(deck) {}

  /// Folders where files that the deck includes may be, besides its own.
  std::vector<std::filesystem::path> folders;

  /// Adds a file; calls read(line) for each of its lines until it returns false. Throws FileError.
  void read_file(const std::filesystem::path& file, const std::function<bool(const DeckLine&)>& read);
  /// The file that a card includes, or a loss: not found, outside of the deck's folders, or includes itself.
  bool include(std::string_view name, const std::string& card, Place at,
               const std::function<bool(const DeckLine&)>& read);
  void lose(Place at, const std::string& card, const std::string& message) {
    deck_.losses.push_back({at, card, message});
  }

 private:
  void count_after_end(char mark, std::string_view text, Place end);

  DeckText& deck_;
  int depth_ = 0;
};

/// Adds the cards of the file, the first one of the deck, and of those that it includes.
void read_lsdyna_text(const std::filesystem::path& file, DeckText& deck);
void read_radioss_text(const std::filesystem::path& file, DeckText& deck);

/// Value of an expression with numbers, parameters, + - * / **, brackets and the usual functions. Throws
/// DeckFault.
double evaluate(std::string_view expression, const DeckText& deck, Place at);

std::string_view without_blanks(std::string_view text);  // around it
std::string in_capitals(std::string_view text);
std::string in_small_letters(std::string_view text);

/// True for a comment of the user: not a header of columns, a ruler or an empty one.
bool is_remark(std::string_view comment);

}  // namespace driver::imported
