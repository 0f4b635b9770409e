// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_head.hpp"
#include "base/progress.hpp"
#include "base/result_folder.hpp"
#include "commands/command.hpp"
#include "engine/bag_mesh.hpp"
#include "export/feature.hpp"
#include "export/lsdyna.hpp"
#include "export/radioss.hpp"
#include "input_files.hpp"
#include "results/load_scene.hpp"
#include "results/results.hpp"

namespace driver::commands {
namespace {

// Throws CaseError for a bag of unlikely size: a deck in the wrong unit would run unnoticed.
void require_size(const Scene& scene, bool any_size) {
  const auto extent = unlikely_extent(scene.bag->mesh);
  if (any_size || !extent) return;
  throw CaseError(
      fmt::format("{}: membrane.mesh: the bag's longest extent is {:.3g} m, allowed: {} to {} m; set "
                  "length_unit to the file's unit, or accept it by --any-size",
                  scene.case_file.string(), *extent, smallest_bag, largest_bag));
}

void tell_omissions(const Deck& deck) {
  const std::size_t inflators = deck.scene->gas ? deck.scene->gas->model.inflows.size() : 0;
  const auto is_inflator = [](const std::string& part) { return part.starts_with("inflator."); };
  const auto left_out =
      static_cast<std::size_t>(std::ranges::count_if(deck.omissions, is_inflator, &DeckOmission::part));
  if (inflators > 0 && left_out == inflators)
    tell(fmt::format("warning: the deck has none of the case's {} inflators", inflators));
  for (const DeckOmission& omission : deck.omissions)
    tell(fmt::format("warning: {} is left out: {}", omission.part, omission.why));
}

std::string json_of(const Deck& deck, const std::vector<UsedFeature>& used,
                    const ExportArguments& arguments) {
  auto object = json_head<nlohmann::ordered_json>();
  object["scene"] = deck.scene->name;
  object["deck"] = arguments.format;
  object["units"] = arguments.units;
  for (const UsedFeature& feature : used)
    object["keys"].push_back({{"key", feature.path},
                              {"value", feature.value},
                              {"mapping", name_of(feature.outcome.mapping)},
                              {"how", feature.outcome.how}});
  object["left_out"] = nlohmann::ordered_json::array();
  for (const DeckOmission& omission : deck.omissions)
    object["left_out"].push_back({{"part", omission.part}, {"why", omission.why}});
  object["notes"] = nlohmann::ordered_json::array();
  for (const DeckNote& note : deck.notes) object["notes"].push_back({{"key", note.key}, {"text", note.text}});
  return object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace

int export_deck(const ExportArguments& arguments) {
  const Units units = units_named(arguments.units);
  CaseDocument document(arguments.scene.file, arguments.scene.overrides);
  const Scene scene = load_scene(document);
  const DeckFormat format = arguments.format == "radioss" ? DeckFormat::radioss : DeckFormat::lsdyna;
  Deck deck = make_deck(scene, format);
  require_size(scene, arguments.any_size);
  if (format == DeckFormat::lsdyna) leave_out_lsdyna_vents(deck);
  const auto used = used_features(document, deck);
  for (DeckNote& note : notes_of_lost(used)) deck.notes.push_back(std::move(note));
  DeckFiles files = format == DeckFormat::radioss ? write_radioss(deck, units) : write_lsdyna(deck, units);
  files.emplace_back("export.md", export_markdown(deck, used,
                                                  fmt::format("{} as a deck of {}, {}", scene.name,
                                                              arguments.format, units.name)));
  files.emplace_back("export.json", json_of(deck, used, arguments));
  std::vector<std::string> names;
  for (const auto& file : files) names.push_back(file.first);
  refuse_inputs(arguments.out, document.files());
  ResultFolder folder(arguments.out, "export");
  folder.begin(provenance(arguments.scene.file, arguments.scene.overrides,
                          id_of("export", {arguments.format, arguments.units}, {&document})));
  for (const auto& [name, text] : files) folder.write(name, text);
  folder.end("done");
  tell_omissions(deck);
  for (const DeckNote& note : deck.notes) fmt::print("{}: {}\n", note.key, note.text);
  fmt::print("{}: {} and {} are in {}\n", one_line(scene.name), names.front(), "export.md",
             arguments.out.string());
  return exit_done;
}

}  // namespace driver::commands
