// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "base/progress.hpp"
#include "base/result_folder.hpp"
#include "base/run_id.hpp"
#include "commands/command.hpp"
#include "import/import_case.hpp"
#include "input_files.hpp"
#include "results/load_scene.hpp"
#include "results/results.hpp"

namespace driver::commands {
namespace {

using imported::CardOutcome;
using imported::ImportedCase;

// What a run would say of the case that was written; empty if it runs.
std::string fault_of(const std::filesystem::path& file) {
  try {
    CaseDocument document(file, {});
    load_scene(document);
    return {};
  } catch (const CaseError& error) {
    return error.what();
  }
}

// Writes the case with what became of the deck, or that alone if the case is none.
void write_files(const ImportedCase& result, const ImportArguments& arguments) {
  ResultFolder folder(arguments.out, "import");
  const std::vector<std::string> options{"import", arguments.units.value_or(""),
                                         fmt::format("{}", arguments.bag.value_or(0)),
                                         arguments.merge_chambers ? "merged" : ""};
  folder.begin(provenance(arguments.deck, {}, run_id(options, result.text.files)));
  for (const auto& [name, text] : result.files)
    folder.write(name, name.ends_with(".csv") ? comment_lines(folder.lines()) + text : text);
  const std::string title = fmt::format("{}, from {}", result.scene, arguments.deck.filename().string());
  folder.write("import.md", result.report.markdown(title));
  folder.write("import.json", import_json(result));
  folder.end("done");
}

void tell_refusals(const ImportedCase& result) {
  for (const CardOutcome& outcome : result.report.outcomes())
    if (outcome.refused)
      tell(fmt::format("{}: {}: {}", result.text.where(outcome.at), outcome.card, outcome.how));
}

}  // namespace

int import_deck(const ImportArguments& arguments) {
  const auto result =
      imported::import_case(arguments.deck, {arguments.bag, arguments.units, arguments.merge_chambers});
  refuse_inputs(arguments.out, result->text.files);
  write_files(*result, arguments);
  const std::string fault =
      result->files.empty() ? "" : fault_of(arguments.out / result->files.front().first);
  if (!fault.empty()) {
    result->files.clear();
    result->report.refuse("case", {0, 0}, "the case would not run: " + fault);
    write_files(*result, arguments);
  }
  if (result->files.empty()) {
    tell_refusals(*result);
    tell(fmt::format("no case is written; {} says what became of each card",
                     (arguments.out / "import.md").string()));
    return exit_input;
  }
  for (const std::string& note : result->report.notes()) fmt::print("{}\n", note);
  fmt::print("{}: {} and import.md are in {}\n", one_line(result->scene), result->files.front().first,
             arguments.out.string());
  return exit_done;
}

}  // namespace driver::commands
