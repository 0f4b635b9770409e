// SPDX-License-Identifier: Apache-2.0
#include "import/import_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "base/result_folder.hpp"
#include "other_cards.hpp"

namespace driver::imported {
namespace {

std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : one_line(text)) escaped += c == '|' ? "\\|" : std::string(1, c);
  return escaped;
}

// Outcomes of a card from the best to the worst.
constexpr std::array<std::string_view, 5> ranks{"exact", "approximated", "left out", "no counterpart",
                                                "refused"};

int rank_of(const CardOutcome& outcome) {
  if (outcome.refused) return static_cast<int>(ranks.size()) - 1;
  return static_cast<int>(std::ranges::find(ranks, std::string_view(name_of(outcome.mapping))) -
                          ranks.begin());
}

constexpr std::size_t most_places = 5;  // of one row; the JSON file has all

std::string places_of(const DeckText& deck, const CardOutcome& outcome) {
  std::string text = deck.where(outcome.at);
  for (std::size_t i = 0; i < std::min(outcome.more.size(), most_places); ++i)
    text += ", " + deck.where(outcome.more[i]);
  if (outcome.more.size() > most_places)
    text += fmt::format(" and {} more", outcome.more.size() - most_places);
  return text;
}

}  // namespace

void ImportReport::add(const DeckCard* card, CardOutcome outcome) {
  if (card != nullptr) {
    int& worst = worst_.try_emplace(card, 0).first->second;
    worst = std::max(worst, rank_of(outcome));
  }
  std::string row =
      fmt::format("{}\n{}\n{}\n{}", outcome.card, rank_of(outcome), outcome.how, outcome.refused);
  for (const std::string& key : outcome.keys) row += '\n' + key;
  const auto [found, is_new] =
      rows_.try_emplace(std::move(row), outcomes_.size(), std::set<std::pair<int, int>>{});
  auto& [number, places] = found->second;
  if (!places.insert({outcome.at.file, outcome.at.line}).second) return;
  if (is_new) return outcomes_.push_back(std::move(outcome));
  ++outcomes_[number].count;
  outcomes_[number].more.push_back(outcome.at);
}

void ImportReport::became(const DeckCard& card, std::vector<std::string> keys, Mapping mapping,
                          std::string how) {
  for (const std::string& key : keys)
    if (!std::ranges::any_of(features(), [&](const Feature& feature) { return key == feature.key; }))
      throw std::logic_error("the table of export has no row for the key " + key);
  if (how.empty()) {
    const auto row =
        std::ranges::find_if(features(), [&](const Feature& f) { return keys.front() == f.key; });
    how = row->in(deck_->program).how;
  }
  add(&card, {card.keyword, card.at, std::move(keys), mapping, std::move(how), false, 1, {}});
}

void ImportReport::left_out(const DeckCard& card, Mapping mapping, std::string how) {
  add(&card, {card.keyword, card.at, {}, mapping, std::move(how), false, 1, {}});
}

// The card whose lines have this place; none before the first card of a file.
const DeckCard* ImportReport::card_at(Place at) const {
  const auto next = by_place_.upper_bound({at.file, at.line});
  if (next == by_place_.begin()) return nullptr;
  const DeckCard* card = std::prev(next)->second;
  return card->at.file == at.file ? card : nullptr;
}

void ImportReport::refuse(const std::string& card, Place at, std::string how) {
  CardOutcome outcome{card, at, {}, Mapping::none, std::move(how), true, 1, {}};
  const DeckCard* own = at.line > 0 ? card_at(at) : nullptr;
  add(own && own->keyword == card ? own : nullptr, std::move(outcome));
}

void ImportReport::refuse(const DeckCard& card, const DeckFault& fault) {
  const DeckCard* own = card_at(fault.at());
  if (own && own != &card) refuse(own->keyword, fault.at(), fault.what());
  refuse(card.keyword, own == &card ? fault.at() : card.at, fault.what());
}

std::map<std::string, int> ImportReport::counts() const {
  std::map<std::string, int> counts;
  for (const std::string_view rank : ranks) counts[std::string(rank)] = 0;
  for (const auto& [card, worst] : worst_) ++counts[std::string(ranks[static_cast<std::size_t>(worst)])];
  return counts;
}

bool ImportReport::refused() const {
  return std::ranges::any_of(outcomes_, &CardOutcome::refused);
}

void ImportReport::finish() {
  for (const DeckLoss& loss : deck_->losses) {
    const bool is_end = loss.card == "*END" || loss.card == "/END";
    if (is_end)
      note(fmt::format("{}: {} {}", deck_->where(loss.at), loss.card, loss.message));
    else
      refuse(loss.card, loss.at, loss.message);
  }
  for (const DeckCard& card : deck_->cards) {
    if (told(card)) continue;
    const OtherCard kind = other_card(card.keyword, deck_->program);
    if (kind.refused)
      refuse(card, kind.how);
    else
      left_out(card, kind.mapping, kind.how);
  }
}

std::string ImportReport::markdown(const std::string& title) const {
  std::string text = fmt::format("# {}\n\n", one_line(title));
  text += refused() ? "No case is written: the bag needs what the first table names.\n\n" : "";
  text += fmt::format("{} cards, each counted by the worst that it became:", worst_.size());
  const auto numbers = counts();
  for (const std::string_view rank : ranks)
    text +=
        fmt::format(" {} {}{}", numbers.at(std::string(rank)), rank, rank == ranks.back() ? ".\n\n" : ",");
  const auto table = [&](const char* heading, auto&& belongs) {
    if (std::ranges::none_of(outcomes_, belongs)) return;
    text += fmt::format("## {}\n\n| card | place | became | how |\n|---|---|---|---|\n", heading);
    for (const CardOutcome& outcome : outcomes_) {
      if (!belongs(outcome)) continue;
      std::string keys;
      for (const std::string& key : outcome.keys)
        keys += fmt::format("{}`{}`", keys.empty() ? "" : ", ", key);
      const std::string number = outcome.count > 1 ? fmt::format(" ({})", outcome.count) : "";
      text += fmt::format("| `{}`{} | {} | {} | {} |\n", cell(outcome.card), number,
                          cell(places_of(*deck_, outcome)), keys, cell(outcome.how));
    }
    text += '\n';
  };
  table("refused", [](const CardOutcome& o) { return o.refused; });
  for (const Mapping mapping : {Mapping::none, Mapping::left_out, Mapping::approximated, Mapping::exact})
    table(name_of(mapping), [&](const CardOutcome& o) { return !o.refused && o.mapping == mapping; });
  if (!notes_.empty()) text += "## In this deck\n\n";
  for (const std::string& remark : notes_) text += fmt::format("- {}\n", one_line(remark));
  return text;
}

}  // namespace driver::imported
