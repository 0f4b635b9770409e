// SPDX-License-Identifier: Apache-2.0
#include "export/feature.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "driver/result_folder.hpp"

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
    used.push_back({setting.path, setting.value, feature->in(deck.format)});
  }
  return used;
}

std::string export_markdown(const Deck& deck, const std::vector<UsedFeature>& used,
                            const std::string& title) {
  std::string text = fmt::format("# {}\n\n", one_line(title));
  for (const Mapping mapping : {Mapping::none, Mapping::approximated, Mapping::exact}) {
    text += fmt::format("## {}\n\n| key | value | how |\n|---|---|---|\n", name_of(mapping));
    for (const UsedFeature& feature : used)
      if (feature.outcome.mapping == mapping)
        text += fmt::format("| `{}` | `{}` | {} |\n", markdown_cell(feature.path),
                            markdown_cell(feature.value), feature.outcome.how);
    text += '\n';
  }
  text += "## In this scene\n\n";
  for (const DeckNote& note : deck.notes) text += fmt::format("- `{}`: {}\n", note.key, note.text);
  if (deck.notes.empty()) text += "Nothing more.\n";
  return text;
}

}  // namespace driver
