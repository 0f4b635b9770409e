// SPDX-License-Identifier: Apache-2.0
// Private to the reader of LS-DYNA decks: sets of nodes.
#pragma once

#include <string>
#include <string_view>

#include "deck_card.hpp"
#include "mesh_text.hpp"

namespace mesh {

/// Reads *SET_NODE and *SET_NODE_LIST, also with _TITLE. Text that is no node number is not read.
class KeywordSets {
 public:
  explicit KeywordSets(DeckMesh& deck) : deck_(deck) {}

  /// True if the keyword begins such a set.
  bool begins(std::string_view word) {
    const bool has_title = word.ends_with("_TITLE");
    if (has_title) word.remove_suffix(std::string_view("_TITLE").size());
    if (word != "*SET_NODE" && word != "*SET_NODE_LIST") return false;
    cards_before_ = has_title ? 2 : 1;
    title_.clear();
    return true;
  }

  void read(std::string_view line, int file, std::size_t line_number, bool is_long) {
    constexpr std::array<std::size_t, 8> short_columns = {10, 10, 10, 10, 10, 10, 10, 10},
                                         long_columns = {20, 20, 20, 20, 20, 20, 20, 20};
    if (cards_before_ == 2) {
      title_ = line;
      cards_before_ = 1;
      return;
    }
    const DeckCard card(deck_, file, line_number, line, is_long ? long_columns : short_columns);
    if (cards_before_ == 1) {
      deck_.sets.begin(title_, card.whole(0).value_or(0));
      cards_before_ = 0;
      return;
    }
    for (std::size_t i = 0; i < 8; ++i)
      if (const auto node = card.whole(i)) deck_.sets.add(*node);
  }

 private:
  DeckMesh& deck_;
  int cards_before_ = 0;  // title and number
  std::string title_;
};

}  // namespace mesh
