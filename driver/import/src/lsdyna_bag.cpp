// SPDX-License-Identifier: Apache-2.0
// An LS-DYNA deck as a bag.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "deck_reader.hpp"
#include "import/import_deck.hpp"
#include "lsdyna_context.hpp"

namespace driver::imported {
namespace {

// Names of *CONTROL_UNITS as those of --units.
std::string lsdyna_unit(const std::string& name) {
  constexpr std::array<std::array<std::string_view, 2>, 14> names{{{"m", "m"},
                                                                   {"mm", "mm"},
                                                                   {"cm", "cm"},
                                                                   {"in", "in"},
                                                                   {"ft", "ft"},
                                                                   {"sec", "s"},
                                                                   {"ms", "ms"},
                                                                   {"micro_s", "us"},
                                                                   {"kg", "kg"},
                                                                   {"g", "g"},
                                                                   {"mtrc_ton", "t"},
                                                                   {"lb", "lbm"},
                                                                   {"slinch", "slinch"},
                                                                   {"s", "s"}}};
  for (const auto& [theirs, ours] : names)
    if (theirs == name) return std::string(ours);
  return "";
}

std::optional<Units> units_of(const DeckText& text, const ImportOptions& options, ImportReport& report) {
  for (const DeckCard& card : text.cards) {
    if (card.keyword != "*CONTROL_UNITS") continue;
    const DeckFields f(text, card, line_or_blank(card, 0), {10, 10, 10, 10});
    const std::string length = lsdyna_unit(in_small_letters(f.blank(0) ? "m" : f.text(0))),
                      time = lsdyna_unit(in_small_letters(f.blank(1) ? "sec" : f.text(1))),
                      mass = lsdyna_unit(in_small_letters(f.blank(2) ? "kg" : f.text(2)));
    if (length.empty() || time.empty() || mass.empty()) {
      if (!options.units)
        report.refuse(card, "the units are not known; state them by --units, such as kg-mm-ms");
      continue;
    }
    report.became(card, {"membrane.mesh.length_unit"}, Mapping::exact,
                  fmt::format("units of all numbers: {}-{}-{}", mass, length, time));
    return import_units(fmt::format("{}-{}-{}", mass, length, time));
  }
  if (options.units) return import_units(*options.units);
  if (!report.refused())
    report.refuse(
        "*CONTROL_UNITS", {0, 0},
        "the deck does not state its units; state them by --units, such as kg-m-s, kg-mm-ms or t-mm-s");
  return std::nullopt;
}

bool is_airbag(const DeckCard& card) {
  return card.keyword.starts_with("*AIRBAG_") && !card.keyword.starts_with("*AIRBAG_REFERENCE_GEOMETRY") &&
         !card.keyword.starts_with("*AIRBAG_SHELL_REFERENCE") &&
         !card.keyword.starts_with("*AIRBAG_INTERACTION");
}

bool is_mapped_airbag(const DeckCard& card) {
  for (const char* word :
       {"*AIRBAG_SIMPLE_AIRBAG_MODEL", "*AIRBAG_WANG_NEFSKE", "*AIRBAG_HYBRID", "*AIRBAG_HYBRID_JETTING"})
    if (is_keyword(card, word)) return true;
  return false;
}

const DeckCard* choose_airbag(const DeckText& text, const ImportOptions& options, ImportReport& report) {
  std::vector<const DeckCard*> all;
  std::vector<long> numbers;
  for (const DeckCard& card : text.cards) {
    if (!is_airbag(card)) continue;
    const bool has_number = card.keyword.ends_with("_ID") && !card.lines.empty();
    all.push_back(&card);
    numbers.push_back(has_number ? DeckFields(text, card, card.lines.front(), {10}).whole(0, "ID")
                                 : static_cast<long>(all.size()));
  }
  if (all.empty()) {
    report.refuse("*AIRBAG", {0, 0}, "the deck has no airbag");
    return nullptr;
  }
  if (options.merge_chambers) {
    report.refuse(*all.front(), "--merge-chambers is for monitored volumes of Radioss; choose one by --bag");
    return nullptr;
  }
  std::size_t chosen = 0;
  if (options.bag) {
    const auto found = std::ranges::find(numbers, *options.bag);
    if (found == numbers.end()) {
      report.refuse("*AIRBAG", all.front()->at, fmt::format("the deck has no airbag {}", *options.bag));
      return nullptr;
    }
    chosen = static_cast<std::size_t>(found - numbers.begin());
  } else if (all.size() > 1) {
    report.refuse(*all[1], fmt::format("the deck has {} airbags; choose one by --bag NUMBER", all.size()));
    return nullptr;
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    if (i != chosen) report.left_out(*all[i], Mapping::left_out, "another airbag");
  if (is_mapped_airbag(*all[chosen])) return all[chosen];
  report.refuse(*all[chosen],
                "this kind of airbag is not mapped, allowed: *AIRBAG_SIMPLE_AIRBAG_MODEL, _WANG_NEFSKE, "
                "_HYBRID and _HYBRID_JETTING");
  return nullptr;
}

std::string title_of(const DeckText& text) {
  for (const DeckCard& card : text.cards)
    if (card.keyword == "*TITLE" && !card.lines.empty())
      return std::string(without_blanks(card.lines.front().text));
  return "";
}

}  // namespace

ImportedDeck map_lsdyna(const DeckText& text, const ImportOptions& options, ImportReport& report) {
  ImportedDeck result;
  result.bag.name = title_of(text);
  const auto units = units_of(text, options, report);
  result.card = choose_airbag(text, options, report);
  if (result.card == nullptr || !units) return result;
  const LsDynaTables tables = lsdyna_tables(report);
  LsDynaContext context{text, tables, report, *units, result.bag, *result.card};
  try {
    const LsDynaEntry entry{result.card, head_lines(*result.card)};
    map_volume(context, context.whole(entry, 0, 0, "SID"), context.whole(entry, 0, 1, "SIDTYP") != 0);
    if (result.bag.facets.empty() && !report.refused())
      report.refuse(*result.card, "the control volume has no shells or segments in this deck");
    require_nodes(result.bag);
    map_surroundings(context);
    const long leak_option = map_gas(context);
    map_fabric(context, leak_option);
    map_supports(context);
  } catch (const DeckFault& fault) {
    report.refuse(*result.card, fault);
  }
  return result;
}

}  // namespace driver::imported
