// SPDX-License-Identifier: Apache-2.0
#include "radioss_tables.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
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
  RadiossTableReader(const DeckText& text, RadiossTables& tables) : text_(text), tables_(tables) {}
  void read(const DeckCard& card);

 private:
  void nodes(const DeckCard& card);
  void shells(const DeckCard& card, std::size_t corners);
  void springs(const DeckCard& card);
  void part(const DeckCard& card);
  void curve(const DeckCard& card);

  const DeckText& text_;
  RadiossTables& tables_;
};

void RadiossTableReader::nodes(const DeckCard& card) {
  for (const DeckLine* line : filled(card)) {
    const DeckFields f(text_, card, *line, {10, 20, 20, 20});
    tables_.nodes[f.whole(0, "node_ID")] = {f.real(1, "Xc"), f.real(2, "Yc"), f.real(3, "Zc")};
  }
}

void RadiossTableReader::shells(const DeckCard& card, std::size_t corners) {
  for (const DeckLine* line : filled(card)) {
    const DeckFields f(text_, card, *line, {10, 10, 10, 10, 10});
    RadiossShell shell{number_of(card), {}, &card, line->at};
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
  tables_.parts[number_of(card)] = {std::string(without_blanks(line_or_blank(card, 0).text)),
                                    f.whole(0, "prop_ID"), f.whole(1, "mat_ID"), f.whole(2, "subset_ID"),
                                    &card};
}

void RadiossTableReader::curve(const DeckCard& card) {
  RadiossCurve curve{{}, &card};
  for (const DeckLine* line : filled(card, 1)) {
    const DeckFields f(text_, card, *line, {20, 20});
    const double x = f.real(0, "X");
    if (!curve.knots.empty() && x < curve.knots.back()[0])
      throw DeckFault(line->at,
                      fmt::format("the function falls back to {:g} after {:g}", x, curve.knots.back()[0]));
    curve.knots.push_back({x, f.real(1, "Y")});
  }
  if (curve.knots.empty()) throw DeckFault(card.at, "the function has no points");
  tables_.curves[number_of(card)] = std::move(curve);
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
  if (word == "MAT") tables_.materials[number] = &card;
  if (word == "PROP") tables_.properties[number] = &card;
  if (word == "LEAK") tables_.leaks[number] = &card;
  if (word == "SURF") tables_.surfaces[number] = &card;
  if (word == "GRNOD") tables_.groups[number] = &card;
  if (word == "SENSOR") tables_.sensors[number] = &card;
  if (word == "SUBSET") tables_.subsets[number] = &card;
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

RadiossTables radioss_tables(const DeckText& text, ImportReport& report) {
  RadiossTables tables;
  RadiossTableReader reader(text, tables);
  for (const DeckCard& card : text.cards) {
    try {
      reader.read(card);
    } catch (const DeckFault& fault) {
      if (card.keyword.starts_with(
              "/FUNCT")) {  // as if it were not there: what of the bag needs it is refused then
        report.left_out(card, Mapping::none, std::string("is not read: ") + fault.what());
        continue;
      }
      report.refuse(card.keyword, fault.at(), fault.what());
      report.told_elsewhere(card);
    }
  }
  return tables;
}

DeckFields RadiossContext::tens(const DeckCard& card, std::size_t line) const {
  return {text, card, line_or_blank(card, line), {10, 10, 10, 10, 10, 10, 10, 10, 10, 10}};
}

DeckFields RadiossContext::twenties(const DeckCard& card, std::size_t line) const {
  return {text, card, line_or_blank(card, line), {20, 20, 20, 20, 20}};
}

Knots RadiossContext::curve(long id, double x_unit, double y_unit, const std::string& key, Place at) const {
  const auto found = tables.curves.find(id);
  if (found == tables.curves.end())
    throw DeckFault(at, fmt::format("names the function {}, which the deck does not have", id));
  Knots knots;
  for (const auto& [x, y] : found->second.knots) knots.push_back({x * x_unit, y * y_unit});
  report.became(*found->second.card, {key}, Mapping::exact,
                "knots in SI units, with the scales of their card applied");
  return knots;
}

std::string RadiossContext::source(const DeckCard& card) const {
  std::string result = fmt::format("{} {}", text.where(card.at), card.keyword);
  if (!card.lines.empty() && !without_blanks(card.lines.front().text).empty())
    result += fmt::format(", {}", without_blanks(card.lines.front().text));
  for (const std::string_view remark : card.comments) result += fmt::format("; {}", remark);
  return result;
}

namespace {

void require_shallow(int depth, Place at) {
  constexpr int deepest = 16;
  if (depth > deepest) throw DeckFault(at, "sets have each other as members, or are more than 16 deep");
}

}  // namespace

std::set<long> RadiossContext::parts_of_surface(long surface, Place at, int depth) const {
  require_shallow(depth, at);
  const auto found = tables.surfaces.find(surface);
  if (found == tables.surfaces.end())
    throw DeckFault(at, fmt::format("names the surface {}, which the deck does not have", surface));
  const DeckCard& card = *found->second;
  const auto words = words_of(card);
  const std::string kind = words.size() > 1 ? words[1] : "";
  std::set<long> parts;
  if (kind == "SEG") return parts;
  if (kind != "PART" && kind != "SURF" && kind != "SUBSET")
    throw DeckFault(card.at,
                    fmt::format("surfaces /SURF/{} are not read, allowed: PART, SUBSET, SURF and SEG", kind));
  for (const long member : numbers_of(text, card)) {
    if (kind == "PART") parts.insert(member);
    if (kind == "SURF" && member != surface) parts.merge(parts_of_surface(member, card.at, depth + 1));
    if (kind == "SUBSET")
      for (const auto& [id, part] : tables.parts)
        if (part.subset == member) parts.insert(id);
  }
  report.became(card, {"membrane.mesh.file"}, Mapping::exact, "a surface of the bag");
  return parts;
}

std::vector<Facet> RadiossContext::segments_of_surface(long surface, Place at, int depth) const {
  require_shallow(depth, at);
  const auto found = tables.surfaces.find(surface);
  if (found == tables.surfaces.end())
    throw DeckFault(at, fmt::format("names the surface {}, which the deck does not have", surface));
  const DeckCard& card = *found->second;
  const auto words = words_of(card);
  std::vector<Facet> segments;
  if (words.size() > 1 && words[1] == "SURF")
    for (const long member : numbers_of(text, card))
      if (member != surface)
        for (Facet& facet : segments_of_surface(member, card.at, depth + 1))
          segments.push_back(std::move(facet));
  if (words.size() < 2 || words[1] != "SEG") return segments;
  for (const DeckLine* line : filled(card, 1)) {
    const DeckFields f(text, card, *line, {10, 10, 10, 10, 10});
    Facet facet{{}, "segments", line->at};
    for (std::size_t i = 1; i < 5; ++i)
      if (const long node = f.whole(i, "node"); node > 0) facet.nodes.push_back(node);
    segments.push_back(std::move(facet));
  }
  report.became(card, {"membrane.mesh.file"}, Mapping::exact, "segments of the bag's surface");
  return segments;
}

std::set<long> RadiossContext::nodes_of_group(long group, Place at, int depth) const {
  require_shallow(depth, at);
  const auto found = tables.groups.find(group);
  if (found == tables.groups.end())
    throw DeckFault(at, fmt::format("names the node group {}, which the deck does not have", group));
  const DeckCard& card = *found->second;
  const auto words = words_of(card);
  const std::string kind = words.size() > 1 ? words[1] : "";
  std::set<long> nodes;
  const auto add_parts = [&](const std::set<long>& parts) {
    for (const RadiossShell& shell : tables.shells)
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
      add_parts(parts_of_surface(member, card.at));
    else
      throw DeckFault(
          card.at, fmt::format("groups /GRNOD/{} are not read, allowed: NODE, GRNOD, PART and SURF", kind));
  }
  report.told_elsewhere(card);
  return nodes;
}

double RadiossContext::area_of(long part) const {
  const auto panel = panels.find(part);
  double area = 0.0;
  for (const Facet& facet : bag.facets) {
    if (panel == panels.end() || facet.panel != panel->second || facet.nodes.empty()) continue;
    const Eigen::Vector3d& a = bag.nodes.at(facet.nodes.front());
    for (std::size_t i = 1; i + 1 < facet.nodes.size(); ++i)
      area += 0.5 * (bag.nodes.at(facet.nodes[i]) - a).cross(bag.nodes.at(facet.nodes[i + 1]) - a).norm();
  }
  return area;
}

}  // namespace driver::imported
