// SPDX-License-Identifier: Apache-2.0
// Cards of a Radioss starter deck.
#include <fmt/format.h>

#include "deck_reader.hpp"
#include "import/deck_fields.hpp"

namespace driver::imported {
namespace {

class RadiossText {
 public:
  explicit RadiossText(DeckText& deck) : deck_(deck), reader_(deck) {}

  void read(const std::filesystem::path& file) {
    reader_.read_file(file, [this](const DeckLine& line) { return line_of_file(line); });
    close();
    if (!ended_) reader_.lose({0, 0}, "/END", "is missing: is the deck cut off? What is there was read");
  }

 private:
  bool line_of_file(const DeckLine& line) {
    const std::string_view text = line.text;
    if (text.starts_with("#include") || text.starts_with("#INCLUDE")) {
      include(line);
      return true;
    }
    if (text.starts_with('#') || text.starts_with('$')) {
      if (is_remark(text) && open_) card_.comments.push_back(without_blanks(text.substr(1)));
      return true;
    }
    if (!text.starts_with('/')) {
      if (open_)
        card_.lines.push_back(line);
      else if (!without_blanks(text).empty())
        reader_.lose(line.at, "text before /BEGIN", "is not read: a starter deck begins with /BEGIN");
      return true;
    }
    close();
    card_ = {};
    card_.at = line.at;
    card_.keyword = in_capitals(without_blanks(text));
    open_ = true;
    if (card_.keyword != "/END") return true;
    open_ = false;
    ended_ = true;
    return false;
  }

  // The lines of an included file are those of the deck.
  void include(const DeckLine& line) {
    DeckCard card;
    card.keyword = "#INCLUDE";
    card.at = line.at;
    deck_.cards.push_back(card);
    const auto name = line.text.substr(8);
    reader_.include(name, card.keyword, line.at, [this](const DeckLine& next) { return line_of_file(next); });
  }

  void close() {
    if (!open_) return;
    open_ = false;
    if (card_.keyword.starts_with("/PARAMETER/")) parameter();
    if (card_.keyword == "/REFSTA") return reference_state();
    deck_.cards.push_back(std::move(card_));
  }

  // The file that /REFSTA names has lines of nodes; they become a card of their own.
  void reference_state() {
    deck_.cards.push_back(card_);
    DeckCard nodes;
    nodes.keyword = "/REFSTA_FILE";
    const auto lines = filled(card_);
    if (lines.empty()) return reader_.lose(card_.at, card_.keyword, "names no file");
    nodes.at = lines.front()->at;
    const bool found =
        reader_.include(lines.front()->text, card_.keyword, lines.front()->at, [&](const DeckLine& line) {
          if (!line.text.starts_with('#')) nodes.lines.push_back(line);
          return true;
        });
    if (found) deck_.cards.push_back(std::move(nodes));
  }

  // Title, then name and value or formula.
  void parameter() {
    try {
      for (const DeckLine* line : filled(card_, 1)) {
        const std::string_view text = without_blanks(line->text);
        const auto end = text.find_first_of(" \t");
        if (end == std::string_view::npos) continue;
        const double value = evaluate(text.substr(end), deck_, line->at);
        deck_.parameters[in_small_letters(text.substr(0, end))] = value;
      }
    } catch (const DeckFault& fault) {
      if (card_.keyword.find("TEXT") == std::string::npos)
        reader_.lose(fault.at(), card_.keyword, fault.what());
    }
  }

  DeckText& deck_;
  DeckReader reader_;
  DeckCard card_;
  bool open_ = false, ended_ = false;
};

}  // namespace

void read_radioss_text(const std::filesystem::path& file, DeckText& deck) {
  RadiossText(deck).read(file);
}

}  // namespace driver::imported
