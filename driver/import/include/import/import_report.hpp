// SPDX-License-Identifier: Apache-2.0
// What became of each card of a deck.
#pragma once

#include <algorithm>
#include <map>
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
  explicit ImportReport(const DeckText& deck) : deck_(&deck) {
    for (const DeckCard& card : deck.cards) by_place_[{card.at.file, card.at.line}] = &card;
  }

  /// A card became keys of the case. Without `how`, the words of export's table for the first key.
  void became(const DeckCard& card, std::vector<std::string> keys, Mapping mapping, std::string how = {});
  /// A card has no counterpart, or is not mapped, and the case does without it.
  void left_out(const DeckCard& card, Mapping mapping, std::string how);
  /// No case is written because of this card: what it is, what is allowed.
  void refuse(const DeckCard& card, std::string how) { refuse(card.keyword, card.at, std::move(how)); }
  /// The same for a fault in reading the card; another card that the fault lies in is refused with it.
  void refuse(const DeckCard& card, const DeckFault& fault);
  /// The same for what is at a place, which may be none.
  void refuse(const std::string& card, Place at, std::string how);
  /// Reads a card; a fault refuses it.
  template <class Read>
  void guard(const DeckCard& card, Read&& read) {
    try {
      read();
    } catch (const DeckFault& fault) {
      refuse(card, fault);
    }
  }
  /// Calls read(card) for each card of the deck; a fault refuses the card.
  template <class Read>
  void each_card(Read&& read) {
    for (const DeckCard& card : deck_->cards) guard(card, [&] { read(card); });
  }
  /// A remark on the case as a whole.
  void note(std::string text) {
    if (std::find(notes_.begin(), notes_.end(), text) == notes_.end()) notes_.push_back(std::move(text));
  }
  bool told(const DeckCard& card) const { return worst_.contains(&card); }
  /// Gives all cards that no one has named the outcome that their kind has, and what could not be read its
  /// own.
  void finish();

  /// Number of the deck's cards by the worst outcome of each: "refused" and the names of mappings. After
  /// finish() each card counts once.
  std::map<std::string, int> counts() const;
  bool refused() const;
  const std::vector<CardOutcome>& outcomes() const { return outcomes_; }
  const std::vector<std::string>& notes() const { return notes_; }
  const DeckText& deck() const { return *deck_; }
  /// import.md
  std::string markdown(const std::string& title) const;

 private:
  void add(const DeckCard* card, CardOutcome outcome);  // card: none if it is not of the deck
  const DeckCard* card_at(Place at) const;

  const DeckText* deck_;
  std::vector<CardOutcome> outcomes_;
  // Outcomes that differ in their places only: the number in outcomes_, files and lines.
  std::map<std::string, std::pair<std::size_t, std::set<std::pair<int, int>>>> rows_;
  std::vector<std::string> notes_;
  std::map<std::pair<int, int>, const DeckCard*> by_place_;  // file and line
  std::map<const DeckCard*, int> worst_;  // of the outcomes of a card, by their order in counts()
};

}  // namespace driver::imported
