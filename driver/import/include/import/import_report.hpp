// SPDX-License-Identifier: Apache-2.0
// What became of each card of a deck.
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "export/feature.hpp"
#include "import/deck_text.hpp"

namespace driver::imported {

/// One card, or several of a kind that became the same.
struct CardOutcome {
  std::string card;               // keyword
  Place at;                       // of the first one
  std::vector<std::string> keys;  // keys of the case that it became, as export's table names them
  Mapping mapping;
  std::string how;
  bool refused = false;  // the physics needs it, so no case is written
  int count = 1;
  std::vector<Place> more;  // places of the others
};

class ImportReport {
 public:
  explicit ImportReport(const DeckText& deck) : deck_(&deck) {}

  /// A card became keys of the case. Without `how`, the words of export's table for the first key.
  void became(const DeckCard& card, std::vector<std::string> keys, Mapping mapping, std::string how = {});
  /// A card has no counterpart, or is not mapped, and the case does without it.
  void left_out(const DeckCard& card, Mapping mapping, std::string how);
  /// No case is written because of this card: what it is, what is allowed.
  void refuse(const DeckCard& card, std::string how) {
    refuse(card.keyword, card.at, std::move(how));
    told_.insert(&card);
  }
  void refuse(const std::string& card, Place at, std::string how);
  /// A remark on the case as a whole.
  void note(std::string text) {
    if (std::find(notes_.begin(), notes_.end(), text) == notes_.end()) notes_.push_back(std::move(text));
  }
  /// The card is named with another.
  void told_elsewhere(const DeckCard& card) { told_.insert(&card); }
  bool told(const DeckCard& card) const { return told_.contains(&card); }
  /// Gives all cards that no one has named the outcome that their kind has, and what could not be read its
  /// own.
  void finish();

  bool refused() const;
  const std::vector<CardOutcome>& outcomes() const { return outcomes_; }
  const std::vector<std::string>& notes() const { return notes_; }
  const DeckText& deck() const { return *deck_; }
  /// import.md
  std::string markdown(const std::string& title) const;

 private:
  void add(CardOutcome outcome);

  const DeckText* deck_;
  std::vector<CardOutcome> outcomes_;
  std::vector<std::string> notes_;
  std::set<const DeckCard*> told_;
};

}  // namespace driver::imported
