// SPDX-License-Identifier: Apache-2.0
#include "radioss_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "deck_reader.hpp"

namespace driver::imported {

std::vector<std::string> words_of(const DeckCard& card) {
  std::vector<std::string> words;
  for (std::size_t begin = 1; begin <= card.keyword.size();) {
    const auto end = std::min(card.keyword.find('/', begin), card.keyword.size());
    words.emplace_back(without_blanks(std::string_view(card.keyword).substr(begin, end - begin)));
    begin = end + 1;
  }
  return words;
}

long number_of(const DeckCard& card) {
  for (const std::string& word : words_of(card)) {
    long value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error == std::errc() && end == word.data() + word.size()) return value;
  }
  return 0;
}

namespace {

/// Fills the tables card by card.
class RadiossTableReader {
 public:
  RadiossTableReader(RadiossTables& tables, ImportReport& report)
      : text_(report.deck()), tables_(tables), report_(report) {}
  void read(const DeckCard& card);

 private:
  void nodes(const DeckCard& card);
  void shells(const DeckCard& card, std::size_t corners);
  void springs(const DeckCard& card);
  void part(const DeckCard& card);
  void curve(const DeckCard& card);

  const DeckText& text_;
  RadiossTables& tables_;
  ImportReport& report_;
};

void RadiossTableReader::nodes(const DeckCard& card) {
  for (const DeckLine* line : filled(card)) {
    const DeckFields f(text_, card, *line, {10, 20, 20, 20});
    tables_.nodes.put(f.whole(0, "node_ID"), {f.real(1, "Xc"), f.real(2, "Yc"), f.real(3, "Zc")});
  }
}

void RadiossTableReader::shells(const DeckCard& card, std::size_t corners) {
  for (const DeckLine* line : filled(card)) {
    const DeckFields f(text_, card, *line, {10, 10, 10, 10, 10});
    DeckShell shell{number_of(card), {}, &card, line->at};
    for (std::size_t i = 1; i <= corners; ++i)
      if (const long node = f.whole(i, "node"); node > 0) shell.nodes.push_back(node);
    tables_.shells.push_back(std::move(shell));
  }
}

void RadiossTableReader::springs(const DeckCard& card) {
  for (const DeckLine* line : filled(card)) {
    const DeckFields f(text_, card, *line, {10, 10, 10});
    tables_.springs.push_back(
        {number_of(card), f.whole(1, "node_ID1"), f.whole(2, "node_ID2"), &card, line->at});
  }
}

void RadiossTableReader::part(const DeckCard& card) {
  const DeckFields f(text_, card, line_or_blank(card, 1), {10, 10, 10});
  put(tables_.parts, number_of(card),
      RadiossPart{std::string(without_blanks(line_or_blank(card, 0).text)), f.whole(0, "prop_ID"),
                  f.whole(1, "mat_ID"), f.whole(2, "subset_ID"), &card},
      report_);
}

void RadiossTableReader::curve(const DeckCard& card) {
  NumberedCurve curve{{}, &card};
  for (const DeckLine* line : filled(card, 1)) {
    const DeckFields f(text_, card, *line, {20, 20});
    add_knot(curve, f.real(0, "X"), f.real(1, "Y"), line->at);
  }
  if (curve.knots.empty()) throw DeckFault(card.at, "the function has no points");
  put(tables_.curves, number_of(card), std::move(curve), report_);
}

void RadiossTableReader::read(const DeckCard& card) {
  const auto words = words_of(card);
  const std::string& word = words.front();
  const long number = number_of(card);
  if (word == "NODE") return nodes(card);
  if (word == "SHELL") return shells(card, 4);
  if (word == "SH3N") return shells(card, 3);
  if (word == "SPRING" || word == "TRUSS") return springs(card);
  if (word == "PART") return part(card);
  if (word == "FUNCT") return curve(card);
  const auto keep = [&](const char* kind, std::map<long, const DeckCard*>& table) {
    if (word == kind) put(table, number, &card, report_);
  };
  keep("MAT", tables_.materials);
  keep("PROP", tables_.properties);
  keep("LEAK", tables_.leaks);
  keep("SURF", tables_.surfaces);
  keep("GRNOD", tables_.groups);
  keep("SENSOR", tables_.sensors);
  keep("SUBSET", tables_.subsets);
}

// All whole numbers of a card after its title.
std::vector<long> numbers_of(const DeckText& text, const DeckCard& card) {
  std::vector<long> numbers;
  for (const DeckLine* line : filled(card, 1)) {
    const DeckFields f(text, card, *line, 10);
    for (std::size_t i = 0; i < f.size(); ++i)
      if (const long value = f.whole(i, "a member"); value != 0) numbers.push_back(value);
  }
  return numbers;
}

}  // namespace

RadiossTables radioss_tables(ImportReport& report) {
  RadiossTables tables;
  RadiossTableReader reader(tables, report);
  read_tables(report, {"/FUNCT"}, [&](const DeckCard& card) { reader.read(card); });
  return tables;
}

DeckFields RadiossContext::tens(const DeckCard& card, std::size_t line) const {
  return {text, card, line_or_blank(card, line), {10, 10, 10, 10, 10, 10, 10, 10, 10, 10}};
}

DeckFields RadiossContext::twenties(const DeckCard& card, std::size_t line) const {
  return {text, card, line_or_blank(card, line), {20, 20, 20, 20, 20}};
}

Knots RadiossContext::curve(long id, double x_unit, double y_unit, const std::string& key, Place at) const {
  return take_curve(tables.curves, id, x_unit, y_unit, key, at, report);
}

std::string RadiossContext::source(const DeckCard& card) const {
  std::string result = fmt::format("{} {}", text.where(card.at), card.keyword);
  if (!card.lines.empty() && !without_blanks(card.lines.front().text).empty())
    result += fmt::format(", {}", without_blanks(card.lines.front().text));
  for (const std::string_view remark : card.comments) result += fmt::format("; {}", remark);
  return result;
}

namespace {

std::string second_word(const DeckCard& card) {
  const auto words = words_of(card);
  return words.size() > 1 ? words[1] : "";
}

void require_shallow(int depth, Place at) {
  constexpr int deepest = 16;
  if (depth > deepest) throw DeckFault(at, "sets have each other as members, or are more than 16 deep");
}

}  // namespace

RadiossSurface RadiossContext::surface(long number, Place at, int depth) const {
  require_shallow(depth, at);
  const DeckCard& card = *entry_of(tables.surfaces, number, "surface", at);
  const std::string kind = second_word(card);
  RadiossSurface surface;
  if (kind == "SEG") {
    for (const DeckLine* line : filled(card, 1)) {
      const DeckFields f(text, card, *line, {10, 10, 10, 10, 10});
      Facet facet{{}, "segments", line->at};
      for (std::size_t i = 1; i < 5; ++i)
        if (const long node = f.whole(i, "node"); node > 0) facet.nodes.push_back(node);
      surface.segments.push_back(std::move(facet));
    }
  } else if (kind != "PART" && kind != "SURF" && kind != "SUBSET") {
    throw DeckFault(card.at,
                    fmt::format("surfaces /SURF/{} are not read, allowed: PART, SUBSET, SURF and SEG", kind));
  } else {
    for (const long member : numbers_of(text, card)) {
      if (kind == "PART") surface.parts.insert(member);
      if (kind == "SURF" && member != number) {
        RadiossSurface other = this->surface(member, card.at, depth + 1);
        surface.parts.merge(other.parts);
        std::ranges::move(other.segments, std::back_inserter(surface.segments));
      }
      if (kind == "SUBSET")
        for (const auto& [id, part] : tables.parts)
          if (part.subset == member) surface.parts.insert(id);
    }
  }
  report.became(card, {"membrane.mesh.file"}, Mapping::exact, "a surface of the bag");
  return surface;
}

std::set<long> RadiossContext::nodes_of_group(long group, Place at, int depth) const {
  require_shallow(depth, at);
  const DeckCard& card = *entry_of(tables.groups, group, "node group", at);
  const std::string kind = second_word(card);
  std::set<long> nodes;
  const auto add_parts = [&](const std::set<long>& parts) {
    for (const DeckShell& shell : tables.shells)
      if (parts.contains(shell.part)) nodes.insert(shell.nodes.begin(), shell.nodes.end());
  };
  for (const long member : numbers_of(text, card)) {
    if (kind == "NODE")
      nodes.insert(member);
    else if (kind == "GRNOD" && member != group)
      nodes.merge(nodes_of_group(member, card.at, depth + 1));
    else if (kind == "PART")
      add_parts({member});
    else if (kind == "SURF")
      add_parts(surface(member, card.at).parts);
    else
      throw DeckFault(
          card.at, fmt::format("groups /GRNOD/{} are not read, allowed: NODE, GRNOD, PART and SURF", kind));
  }
  report.became(card, {"membrane.mesh.file"}, Mapping::exact, "nodes that other cards name");
  return nodes;
}

}  // namespace driver::imported
