// SPDX-License-Identifier: Apache-2.0
// A Radioss starter deck as a bag.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>

#include "base/text_file.hpp"
#include "deck_reader.hpp"
#include "import/import_deck.hpp"
#include "radioss_chambers.hpp"

namespace driver::imported {
namespace {

// A unit of /BEGIN by its name, of which capitals matter, or as a number of SI units.
double unit_of(const DeckFields& f, std::size_t i) {
  struct Named {
    std::string_view name;
    double si;
  };
  constexpr std::array names{Named{"kg", 1.0},  Named{"g", 1e-3},  Named{"Mg", 1e3},  Named{"t", 1e3},
                             Named{"ton", 1e3}, Named{"mg", 1e-6}, Named{"m", 1.0},   Named{"mm", 1e-3},
                             Named{"cm", 1e-2}, Named{"s", 1.0},   Named{"ms", 1e-3}, Named{"us", 1e-6}};
  for (const Named& unit : names)
    if (f.text(i) == unit.name) return unit.si;
  const double number = f.blank(i) ? 0.0 : f.real(i, "a unit");
  if (!(number > 0.0))
    throw DeckFault(
        f.at(),
        fmt::format("the unit '{}' is not known, allowed: kg, g, Mg, m, cm, mm, s, ms, us or a number",
                    f.text(i)));
  return number;
}

std::optional<Units> units_of_begin(const DeckText& text, const ImportOptions& options, ImportReport& report,
                                    std::string& name) {
  if (options.units) return import_units(*options.units);
  for (const DeckCard& card : text.cards) {
    if (card.keyword != "/BEGIN") continue;
    name = std::string(without_blanks(line_or_blank(card, 0).text));
    const DeckFields f(text, card, line_or_blank(card, 2), {20, 20, 20});
    try {
      const Units units{"", unit_of(f, 0), unit_of(f, 1), unit_of(f, 2), "", "", ""};
      report.became(card, {"membrane.mesh.length_unit"}, Mapping::exact, "units of all numbers");
      return units;
    } catch (const DeckFault& fault) {
      report.refuse(card, fault.what());
      return std::nullopt;
    }
  }
  report.refuse("/BEGIN", {0, 0},
                "the deck does not state its units; state them by --units, such as kg-mm-ms");
  return std::nullopt;
}

// The number on the first line after a keyword of the engine file.
std::optional<double> engine_number(const std::vector<std::string>& lines, std::string_view keyword) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!in_capitals(lines[i]).starts_with(keyword)) continue;
    for (std::size_t j = i + 1; j < lines.size(); ++j) {
      if (lines[j].starts_with('#')) continue;
      const std::string_view word = without_blanks(lines[j]);
      double value = 0.0;
      const std::string_view first = word.substr(0, word.find_first_of(" \t"));
      const auto [end, error] = std::from_chars(first.data(), first.data() + first.size(), value);
      if (error == std::errc() && end != first.data()) return value;
      break;
    }
  }
  return std::nullopt;
}

// End of the run and interval of the histories, from the engine file NAME_0001.rad beside NAME_0000.rad.
void read_engine(const DeckText& text, const Units& units, BagDeck& bag, ImportReport& report) {
  std::string name = text.files.front().filename().string();
  const auto number = name.rfind("_0000");
  if (number != std::string::npos) name.replace(number, 5, "_0001");
  const auto file = text.files.front().parent_path() / name;
  std::vector<std::string> lines;
  if (number != std::string::npos) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line) && lines.size() < 100000;) lines.push_back(line);
  }
  const auto end = engine_number(lines, "/RUN");
  if (!end || !(*end > 0.0))
    return report.refuse(
        "/RUN", {0, 0},
        fmt::format("the end of the run is in the engine file {}, which is not there or has none", name));
  bag.end_time = *end * units.time;
  if (const auto interval = engine_number(lines, "/TFILE"); interval && *interval > 0.0)
    bag.history_every = *interval * units.time;
  report.note(fmt::format("the end of the run, {:g} s, is that of the engine file {}", bag.end_time, name));
}

bool is_mapped(const DeckCard& card) {
  constexpr std::array kinds{"/MONVOL/AIRBAG1/", "/MONVOL/AIRBAG/", "/MONVOL/COMMU1/", "/MONVOL/COMMU/",
                             "/MONVOL/GAS/"};
  return std::ranges::any_of(kinds, [&](const char* kind) { return card.keyword.starts_with(kind); });
}

// The volumes of the bag: one, or all chambers of one bag; none if that is refused.
std::vector<const DeckCard*> choose_volumes(const DeckText& text, const ImportOptions& options,
                                            ImportReport& report) {
  std::vector<const DeckCard*> all, chosen;
  for (const DeckCard& card : text.cards)
    if (card.keyword.starts_with("/MONVOL/")) all.push_back(&card);
  for (const DeckCard* card : all)
    if (options.merge_chambers || !options.bag || number_of(*card) == *options.bag) chosen.push_back(card);
  if (all.empty())
    report.refuse("/MONVOL", {0, 0}, "the deck has no monitored volume");
  else if (chosen.empty())
    report.refuse(*all.front(), fmt::format("the deck has no monitored volume {}", *options.bag));
  else if (chosen.size() > 1 && !options.merge_chambers)
    report.refuse(*all[1],
                  fmt::format("the deck has {} monitored volumes; choose one by --bag NUMBER, or make one "
                              "chamber of all by --merge-chambers",
                              all.size()));
  if (report.refused()) return {};
  for (const DeckCard* card : all)
    if (std::ranges::find(chosen, card) == chosen.end())
      report.left_out(*card, Mapping::left_out, "another monitored volume");
  for (const DeckCard* card : chosen)
    if (!is_mapped(*card))
      report.refuse(
          *card,
          "this kind of monitored volume is not mapped, allowed: AIRBAG1, AIRBAG, COMMU1, COMMU and GAS");
  return report.refused() ? std::vector<const DeckCard*>{} : chosen;
}

}  // namespace

ImportedDeck map_radioss(const DeckText& text, const ImportOptions& options, ImportReport& report) {
  ImportedDeck result;
  const auto units = units_of_begin(text, options, report, result.bag.name);
  const auto volumes = choose_volumes(text, options, report);
  if (volumes.empty() || !units) return result;
  result.card = volumes.front();
  const RadiossTables tables = radioss_tables(report);
  PanelNames panels;
  const auto context = [&](const DeckCard* volume) {
    return RadiossContext{text, tables, report, *units, result.bag, *volume, panels, volumes.size() > 1};
  };
  RadiossChambers chambers(result.bag, report);
  try {
    read_engine(text, *units, result.bag, report);
    for (const DeckCard* volume : volumes) {
      RadiossContext chamber = context(volume);
      map_surface(chamber);
      panels = chamber.panels;
      chambers.take();
    }
    require_nodes(result.bag);
    chambers.join();
    for (const DeckCard* volume : volumes) {
      RadiossContext chamber = context(volume);
      map_gas(chamber);
      chambers.fill(chamber);
    }
    RadiossContext bag = context(result.card);
    map_fabric(bag);
    map_surroundings(bag);
  } catch (const DeckFault& fault) {
    report.refuse(*result.card, fault);
  }
  return result;
}

}  // namespace driver::imported
