// SPDX-License-Identifier: Apache-2.0
#include "export/feature.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "base/result_folder.hpp"

namespace driver {
namespace {

// A cell of a table.
std::string markdown_cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
  return escaped;
}

}  // namespace

const char* name_of(Mapping mapping) {
  return mapping == Mapping::exact          ? "exact"
         : mapping == Mapping::approximated ? "approximated"
         : mapping == Mapping::left_out     ? "left out"
                                            : "no counterpart";
}

namespace {

// The row of a setting's path, or nullptr.
const Feature* row_of(const std::vector<Feature>& table, const std::string& path) {
  std::string key;
  for (const PathPart& part : split_path(path))
    if (!part.index) key += fmt::format("{}{}", key.empty() ? "" : ".", part.key);
  const Feature* longest = nullptr;
  for (const Feature& feature : table) {
    const std::string_view name = feature.key;
    if (!key.starts_with(name) || (key.size() > name.size() && key[name.size()] != '.')) continue;
    if (longest == nullptr || name.size() > std::string_view(longest->key).size()) longest = &feature;
  }
  return longest;
}

bool is_below(const std::string& path, const std::string& part) {
  return path == part || path.starts_with(part + '.');
}

// Sensors, triggers and species that the parts of a deck use.
struct Served {
  std::vector<bool> nodes;        // nodes of the triggers
  std::set<std::string> species;  // names of species

  explicit Served(const Deck& deck) {
    if (!deck.scene->gas) return;
    const GasPart& gas = *deck.scene->gas;
    nodes.resize(gas.model.triggers.size());
    add_species(gas.model.thermo, gas.initial_fractions);
    for (std::size_t i = 0; i < gas.model.inflows.size(); ++i) {
      if (leaves_out(deck, fmt::format("inflator.{}", i))) continue;
      add_species(gas.model.thermo, gas.model.inflows[i].mass_fractions);
      add_nodes(gas.model.triggers, gas.model.inflows[i].trigger);
    }
    for (std::size_t i = 0; i < gas.model.vents.size(); ++i)
      if (!leaves_out(deck, fmt::format("vent.{}", i)))
        add_nodes(gas.model.triggers, gas.model.vents[i].trigger);
  }

  static bool leaves_out(const Deck& deck, const std::string& part) {
    return std::ranges::find(deck.omissions, part, &DeckOmission::part) != deck.omissions.end();
  }
  void add_species(const gas::Thermo& thermo, const std::vector<double>& fractions) {
    for (std::size_t k = 0; k < thermo.size(); ++k)
      if (fractions[k] > 0.0) species.insert(thermo.species(k).name);
  }
  void add_nodes(const gas::TriggerModel& triggers, std::optional<std::size_t> node) {
    if (!node) return;
    const auto behind = gas::nodes_behind(triggers, *node);
    for (std::size_t i = 0; i < behind.size(); ++i) nodes[i] = nodes[i] || behind[i];
  }
};

// Paths of settings that serve no part of the deck.
std::vector<std::string> idle_paths(const CaseDocument& document, const Deck& deck) {
  const Served served(deck);
  std::vector<std::string> idle;
  for (std::size_t i = 0; i < served.nodes.size(); ++i) {
    const std::size_t sensors = deck.scene->gas->model.triggers.sensors.size();
    if (!served.nodes[i])
      idle.push_back(i < sensors ? fmt::format("sensor.{}", i) : fmt::format("trigger.{}", i - sensors));
  }
  for (const Setting& setting : document.settings()) {
    const auto path = split_path(setting.path);
    const bool is_name =
        setting.path.starts_with("gas.species.") && path.size() == 4 && path[3].key == "name";
    const auto has_name = [&](const std::string& name) { return setting.value == '"' + name + '"'; };
    if (is_name && std::ranges::none_of(served.species, has_name))
      idle.push_back("gas.species." + path[2].key);
  }
  return idle;
}

// Marks the keys of parts that the deck leaves out, and keys that serve nothing in the deck.
void leave_out(const CaseDocument& document, const Deck& deck, std::vector<UsedFeature>& used) {
  const auto idle = idle_paths(document, deck);
  for (UsedFeature& feature : used) {
    const auto holds = [&](const std::string& part) { return is_below(feature.path, part); };
    if (std::ranges::any_of(deck.omissions, holds, &DeckOmission::part))
      feature.outcome = {Mapping::left_out, "see below"};
    else if (std::ranges::any_of(idle, holds))
      feature.outcome = {Mapping::left_out, "serves no part of the deck"};
  }
}

}  // namespace

std::vector<UsedFeature> used_features(const CaseDocument& document, const Deck& deck) {
  const std::string law = deck.scene->bag->model.description.law;
  std::vector<UsedFeature> used;
  for (const Setting& setting : document.settings()) {
    const Feature* feature = row_of(features(), setting.path);
    if (!deck.threads[0].curve.empty())
      if (const Feature* of_curves = row_of(features_of_curves(), setting.path)) feature = of_curves;
    const bool own = feature == nullptr && setting.path.starts_with("fabric.");
    if (!is_mapped(law) && (own || setting.path == "fabric.law")) feature = &feature_of_other_laws();
    if (feature == nullptr)
      throw std::logic_error(fmt::format("the table of export has no row for the key {}", setting.path));
    used.push_back({setting.path, setting.value, feature->in(deck.format), setting.is_default});
  }
  leave_out(document, deck, used);
  return used;
}

std::vector<DeckNote> notes_of_lost(const std::vector<UsedFeature>& used) {
  std::vector<DeckNote> notes;
  for (const UsedFeature& feature : used)
    if (feature.outcome.lost && !feature.is_default && feature.value != "false")
      notes.push_back(
          {feature.path, fmt::format("{} has no counterpart: {}", feature.value, feature.outcome.how)});
  return notes;
}

std::string export_markdown(const Deck& deck, const std::vector<UsedFeature>& used,
                            const std::string& title) {
  std::string text = fmt::format("# {}\n\n", one_line(title));
  for (const Mapping mapping : {Mapping::left_out, Mapping::none, Mapping::approximated, Mapping::exact}) {
    if (std::ranges::none_of(used, [&](const auto& feature) { return feature.outcome.mapping == mapping; }))
      continue;
    text += fmt::format("## {}\n\n| key | value | how |\n|---|---|---|\n", name_of(mapping));
    for (const UsedFeature& feature : used)
      if (feature.outcome.mapping == mapping)
        text += fmt::format("| `{}` | `{}` | {} |\n", markdown_cell(feature.path),
                            markdown_cell(feature.value), feature.outcome.how);
    text += '\n';
  }
  text += "## In this scene\n\n";
  for (const DeckOmission& omission : deck.omissions)
    text += fmt::format("- `{}` is left out: {}\n", omission.part, omission.why);
  for (const DeckNote& note : deck.notes) text += fmt::format("- `{}`: {}\n", note.key, note.text);
  if (deck.notes.empty() && deck.omissions.empty()) text += "Nothing more.\n";
  return text;
}

}  // namespace driver
