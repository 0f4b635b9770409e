// SPDX-License-Identifier: Apache-2.0
// Cards of an LS-DYNA keyword deck.
#include <fmt/format.h>

#include "deck_reader.hpp"
#include "import/deck_fields.hpp"

namespace driver::imported {
namespace {

class LsDynaText {
 public:
  explicit LsDynaText(DeckText& deck) : deck_(deck), reader_(deck) {}

  void read(const std::filesystem::path& file) {
    reader_.read_file(file, [this](const DeckLine& line) { return line_of_file(line); });
    close();
    if (!ended_) reader_.lose({0, 0}, "*END", "is missing: is the deck cut off? What is there was read");
  }

 private:
  bool line_of_file(const DeckLine& line) {
    const std::string_view text = line.text;
    if (text.starts_with('$')) {
      if (is_remark(text)) remarks_.push_back(without_blanks(text.substr(1)));
      return true;
    }
    if (!text.starts_with('*')) {
      if (open_)
        card_.lines.push_back(line);
      else if (!without_blanks(text).empty())
        reader_.lose(line.at, "text before *KEYWORD", "is not read: a deck begins with *KEYWORD");
      if (open_) card_.comments.insert(card_.comments.end(), remarks_.begin(), remarks_.end());
      if (open_) remarks_.clear();
      return true;
    }
    close();
    return begin(line);
  }

  // Starts a card; false at the end of the file.
  bool begin(const DeckLine& line) {
    std::string word = in_capitals(without_blanks(line.text.substr(0, line.text.find_first_of(" \t,"))));
    const std::string_view rest = without_blanks(line.text.substr(std::min(word.size(), line.text.size())));
    card_ = {};
    card_.at = line.at;
    card_.is_long = word.ends_with('+') || (all_long_ && !word.ends_with('-'));
    if (word.ends_with('+') || word.ends_with('-')) word.pop_back();
    if (word == "*END") {
      ended_ = true;
      return false;
    }
    if (word == "*KEYWORD")
      options(in_capitals(rest), line.at);
    else if (!rest.empty())
      reader_.lose(line.at, word,
                   fmt::format("'{}' after the keyword means other columns, which are not read", rest));
    card_.keyword = std::move(word);
    open_ = true;
    return true;
  }

  void options(const std::string& text, Place at) {
    all_long_ = text.find("LONG=Y") != std::string::npos || text.find("LONG=K") != std::string::npos;
    if (text.find("I10=Y") != std::string::npos)
      reader_.lose(at, "*KEYWORD", "I10=Y (elements in ten columns) is not read; allowed: LONG=Y or nothing");
  }

  void close() {
    if (!open_) return;
    open_ = false;
    const std::string word = card_.keyword;
    if (word == "*INCLUDE" || word == "*INCLUDE_PATH" || word == "*INCLUDE_PATH_RELATIVE")
      return included(DeckCard(card_));
    if (word.starts_with("*PARAMETER")) parameters();
    deck_.cards.push_back(std::move(card_));
  }

  // Files of one card; " +" at the end of a line continues the name.
  void included(const DeckCard& card) {
    deck_.cards.push_back(card);
    std::string name;
    for (const DeckLine* line : filled(card)) {
      std::string part(without_blanks(line->text));
      const bool goes_on = part.ends_with(" +") || part == "+";
      if (goes_on) part = std::string(without_blanks(std::string_view(part).substr(0, part.size() - 1)));
      name += part;
      if (goes_on) continue;
      if (card.keyword != "*INCLUDE")
        reader_.folders.push_back(deck_.files.front().parent_path() / name);
      else
        reader_.include(name, card.keyword, line->at,
                        [this](const DeckLine& next) { return line_of_file(next); });
      close();
      name.clear();
    }
  }

  // Type and name in ten columns, then the value or, with EXPRESSION, its formula.
  void parameters() {
    const bool formula = card_.keyword.find("EXPRESSION") != std::string::npos;
    for (const DeckLine* line : filled(card_)) {
      try {
        if (formula) {
          define(line->text.substr(0, 10), line->text.substr(std::min<std::size_t>(10, line->text.size())),
                 line->at);
          continue;
        }
        const DeckFields fields(deck_, card_, *line, 10);
        for (std::size_t i = 0; i + 1 < fields.size(); i += 2)
          if (!fields.blank(i)) define(fields.text(i), fields.text(i + 1), line->at);
      } catch (const DeckFault& fault) {
        reader_.lose(fault.at(), card_.keyword, fault.what());
      }
    }
  }

  void define(std::string_view name, std::string_view value, Place at) {
    name = without_blanks(name);
    const char type = name.empty() ? ' ' : in_capitals(name.substr(0, 1))[0];
    if (type != 'R' && type != 'I') return;  // text
    const double number = evaluate(value, deck_, at);
    deck_.parameters[in_small_letters(without_blanks(name.substr(1)))] = number;
  }

  DeckText& deck_;
  DeckReader reader_;
  DeckCard card_;
  std::vector<std::string_view> remarks_;
  bool open_ = false, all_long_ = false, ended_ = false;
};

}  // namespace

void read_lsdyna_text(const std::filesystem::path& file, DeckText& deck) {
  LsDynaText(deck).read(file);
}

}  // namespace driver::imported
