// SPDX-License-Identifier: Apache-2.0
#include "lsdyna_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck_reader.hpp"

namespace driver::imported {

bool is_keyword(const DeckCard& card, std::string_view word) {
  const std::string_view own = card.keyword;
  if (!own.starts_with(word)) return false;
  const std::string_view rest = own.substr(word.size());
  return rest.empty() || rest == "_TITLE" || rest == "_ID" || rest == "_ID_TITLE" || rest == "_TITLE_ID";
}

std::size_t head_lines(const DeckCard& card) {
  return card.keyword.ends_with("_TITLE") || card.keyword.ends_with("_ID") ? 1 : 0;
}

namespace {

/// Fills the tables card by card.
class LsDynaTableReader {
 public:
  LsDynaTableReader(LsDynaTables& tables, ImportReport& report)
      : text_(report.deck()), tables_(tables), report_(report) {}
  void read(const DeckCard& card);

 private:
  void nodes(const DeckCard& card);
  void shells(const DeckCard& card);
  void lines(const DeckCard& card, std::vector<DeckLink>& into, int nodes_from);
  void solids(const DeckCard& card);
  void parts(const DeckCard& card);
  void sections(const DeckCard& card);
  void curve(const DeckCard& card);
  void set(const DeckCard& card, std::map<long, LsDynaSet>& into);
  void segments(const DeckCard& card);
  void entry(const DeckCard& card, std::map<long, LsDynaEntry>& into);
  long first_number(const DeckCard& card, std::size_t line) const {
    return DeckFields(text_, card, line_or_blank(card, line), {10}).whole(0, "the number");
  }

  const DeckText& text_;
  LsDynaTables& tables_;
  ImportReport& report_;
};

void LsDynaTableReader::nodes(const DeckCard& card) {
  for (const DeckLine* line : filled(card)) {
    const DeckFields f(text_, card, *line, {8, 16, 16, 16, 8, 8});
    const long id = f.whole(0, "NID");
    tables_.nodes.put(id, {f.real(1, "X"), f.real(2, "Y"), f.real(3, "Z")});
    if (const long code = f.whole(4, "TC"); code != 0) tables_.held[id] = code;
  }
}

void LsDynaTableReader::shells(const DeckCard& card) {
  const std::string_view options =
      std::string_view(card.keyword).substr(std::string_view("*ELEMENT_SHELL").size());
  const bool of_shape = options.find("THICKNESS") != options.npos || options.find("BETA") != options.npos ||
                        options.find("MCID") != options.npos;
  const std::size_t more = of_shape + (options.find("OFFSET") != options.npos);
  const auto lines = filled(card);
  for (std::size_t i = 0; i < lines.size(); i += 1 + more) {
    const DeckFields f(text_, card, *lines[i], {8, 8, 8, 8, 8, 8});
    DeckShell shell{f.whole(1, "PID"), {}, &card, lines[i]->at};
    for (std::size_t n = 2; n < 6; ++n)
      if (const long node = f.whole(n, "node"); node > 0) shell.nodes.push_back(node);
    tables_.shells.push_back(std::move(shell));
  }
}

void LsDynaTableReader::lines(const DeckCard& card, std::vector<DeckLink>& into, int nodes_from) {
  const bool many = card.keyword.find("THICKNESS") != std::string::npos ||
                    card.keyword.find("SCALAR") != std::string::npos ||
                    card.keyword.find("SECTION") != std::string::npos ||
                    card.keyword.find("ORIENTATION") != std::string::npos;
  const auto all = filled(card);
  for (std::size_t i = 0; i < all.size(); i += many ? 2 : 1) {
    const DeckFields f(text_, card, *all[i], {8, 8, 8, 8});
    const auto from = static_cast<std::size_t>(nodes_from);
    into.push_back({f.whole(1, "PID"), f.whole(from, "N1"), f.whole(from + 1, "N2"), &card, all[i]->at});
  }
}

void LsDynaTableReader::solids(const DeckCard& card) {
  for (const DeckLine* line : filled(card)) {
    const DeckFields f(text_, card, *line, {8, 8, 8, 8, 8, 8, 8, 8, 8, 8});
    for (std::size_t n = 2; n < 10; ++n)
      if (const long node = f.whole(n, "node"); node > 0)
        tables_.part_of_solid_node[node] = f.whole(1, "PID");
  }
}

void LsDynaTableReader::parts(const DeckCard& card) {
  const bool has_options = card.keyword != "*PART";
  for (std::size_t i = 0; i + 1 < card.lines.size(); i += 2) {
    const DeckFields f(text_, card, card.lines[i + 1], {10, 10, 10});
    if (f.blank(0) && without_blanks(card.lines[i].text).empty()) break;
    put(tables_.parts, f.whole(0, "PID"),
        LsDynaPart{std::string(without_blanks(card.lines[i].text)), f.whole(1, "SECID"), f.whole(2, "MID"),
                   &card},
        report_);
    if (has_options) break;  // further lines are of the options
  }
}

void LsDynaTableReader::sections(const DeckCard& card) {
  const std::size_t head = head_lines(card), step = head + 2;
  const std::size_t lines = card.keyword.starts_with("*SECTION_SHELL") ? step : card.lines.size() + 1;
  for (std::size_t i = head; i < card.lines.size(); i += lines)
    if (const long id = first_number(card, i); id != 0)
      put(tables_.sections, id, LsDynaEntry{&card, i}, report_);
}

void LsDynaTableReader::curve(const DeckCard& card) {
  const std::size_t head = head_lines(card);
  const DeckFields f(text_, card, line_or_blank(card, head), {10, 10, 10, 10, 10, 10, 10, 10});
  const double sfa = or_one(f.real(2, "SFA")), sfo = or_one(f.real(3, "SFO")), offa = f.real(4, "OFFA"),
               offo = f.real(5, "OFFO");
  NumberedCurve curve{{}, &card};
  for (const DeckLine* line : filled(card, head + 1)) {
    const DeckFields p(text_, card, *line, {20, 20});
    add_knot(curve, sfa * (p.real(0, "A1") + offa), sfo * (p.real(1, "O1") + offo), line->at);
  }
  if (curve.knots.empty()) throw DeckFault(card.at, "the curve has no points");
  put(tables_.curves, f.whole(0, "LCID"), std::move(curve), report_);
}

void LsDynaTableReader::set(const DeckCard& card, std::map<long, LsDynaSet>& into) {
  const bool generate = card.keyword.find("_GENERATE") != std::string::npos,
             add = card.keyword.find("_ADD") != std::string::npos,
             general = card.keyword.find("_GENERAL") != std::string::npos && !generate;
  const std::size_t head = head_lines(card);
  LsDynaSet set{{}, {}, &card};
  if (general) throw DeckFault(card.at, "sets _GENERAL are not read, allowed: _LIST, _GENERATE and _ADD");
  for (const DeckLine* line : filled(card, head + 1)) {
    const DeckFields f(text_, card, *line, 10);
    for (std::size_t i = 0; i < f.size(); ++i) {
      const long value = f.whole(i, "a member");
      if (value == 0) continue;
      if (add) {
        const auto other = into.find(value);
        if (other == into.end())
          throw DeckFault(line->at, fmt::format("the set {} is not defined before", value));
        set.members.insert(set.members.end(), other->second.members.begin(), other->second.members.end());
      } else if (generate && i + 1 < f.size()) {
        const long last = f.whole(++i, "a member");
        constexpr long most = 10'000'000;
        if (last < value || last - value > most)
          throw DeckFault(line->at, "the range of a set is empty or too long");
        for (long member = value; member <= last; ++member) set.members.push_back(member);
      } else {
        set.members.push_back(value);
      }
    }
  }
  put(into, first_number(card, head), std::move(set), report_);
}

void LsDynaTableReader::segments(const DeckCard& card) {
  const std::size_t head = head_lines(card);
  LsDynaSet set{{}, {}, &card};
  for (const DeckLine* line : filled(card, head + 1)) {
    const DeckFields f(text_, card, *line, {10, 10, 10, 10});
    Facet facet{{}, "", line->at};
    for (std::size_t i = 0; i < 4; ++i)
      if (const long node = f.whole(i, "node"); node > 0) facet.nodes.push_back(node);
    set.segments.push_back(std::move(facet));
  }
  put(tables_.segment_sets, first_number(card, head), std::move(set), report_);
}

void LsDynaTableReader::entry(const DeckCard& card, std::map<long, LsDynaEntry>& into) {
  const std::size_t head = head_lines(card);
  put(into, first_number(card, head), LsDynaEntry{&card, head}, report_);
}

void LsDynaTableReader::read(const DeckCard& card) {
  const std::string_view word = card.keyword;
  const auto begins = [&](std::string_view start) { return word.starts_with(start); };
  if (word == "*NODE") return nodes(card);
  if (begins("*ELEMENT_SHELL")) return shells(card);
  if (begins("*ELEMENT_SOLID")) return solids(card);
  if (begins("*ELEMENT_DISCRETE")) return lines(card, tables_.springs, 2);
  if (begins("*ELEMENT_BEAM")) return lines(card, tables_.beams, 2);
  if (word == "*ELEMENT_SEATBELT") return lines(card, tables_.belts, 2);
  if (word == "*PART" || begins("*PART_INERTIA") || begins("*PART_CONTACT")) return parts(card);
  if (begins("*SECTION_")) return sections(card);
  if (begins("*MAT_ADD_AIRBAG_POROSITY_LEAKAGE")) return entry(card, tables_.leakages);
  if (begins("*MAT_ADD_")) return;
  if (begins("*MAT_")) return entry(card, tables_.materials);
  if (is_keyword(card, "*DEFINE_CURVE")) return curve(card);
  if (begins("*SET_PART")) return set(card, tables_.part_sets);
  if (begins("*SET_NODE")) return set(card, tables_.node_sets);
  if (begins("*SET_SHELL")) return set(card, tables_.shell_sets);
  if (begins("*SET_SEGMENT")) return segments(card);
}

}  // namespace

LsDynaTables lsdyna_tables(ImportReport& report) {
  LsDynaTables tables;
  LsDynaTableReader reader(tables, report);
  read_tables(report, {"*SET_", "*DEFINE_"}, [&](const DeckCard& card) { reader.read(card); });
  return tables;
}

}  // namespace driver::imported
