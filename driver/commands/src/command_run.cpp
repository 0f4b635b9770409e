// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdio>

#include "base/progress.hpp"
#include "commands/command.hpp"
#include "engine/run.hpp"
#include "forecast/jet_peak.hpp"
#include "input_files.hpp"
#include "results/load_scene.hpp"
#include "results/results.hpp"
#include "results/run_to_folder.hpp"
#include "results/skin_checks.hpp"

namespace driver::commands {

void tell_warnings(Scene& scene) {
  add_jet_warnings(scene);
  add_skin_warning(scene);
  for (const auto& warning : scene.warnings) tell("warning: " + warning);
}

int tell_interrupted(const std::filesystem::path& kept) {
  tell(fmt::format("gasjet: interrupted: finished runs are in {}, run the same command to continue",
                   kept.string()));
  return exit_interrupted;
}

int run(const RunArguments& arguments) {
  CaseDocument document(arguments.scene.file, arguments.scene.overrides);
  Scene scene = load_scene(document);
  tell_warnings(scene);
  const auto folder =
      arguments.out.empty() ? std::filesystem::path("results") / arguments.scene.file.stem() : arguments.out;
  refuse_inputs(folder, document.files());
  const std::string id = id_of("run", {}, {&document});
  // Before the first step there is nothing to keep, so a signal ends the program at once.
  const auto outcome =
      run_to_folder(scene, folder, provenance(arguments.scene.file, arguments.scene.overrides, id),
                    {.quiet = arguments.quiet,
                     .threads = arguments.threads,
                     .ready = catch_interrupt,
                     .document = &document});
  for (const auto& note : outcome.notes) tell("warning: " + note);
  if (!outcome.warning.empty()) tell("warning: " + outcome.warning);
  if (outcome.status == RunStatus::inaccurate) {
    tell(fmt::format("gasjet: inaccurate: {}\nResults are in {}", outcome.message, folder.string()));
    return exit_domain;
  }
  if (outcome.status == RunStatus::failed) {
    tell(fmt::format("gasjet: {}\nResults so far are in {}", outcome.message, folder.string()));
    return exit_domain;
  }
  if (!arguments.quiet)
    fmt::print("{}: {} in {:.2f} s, results in {}\n", one_line(scene.name),
               outcome.status == RunStatus::done ? "done" : "interrupted", outcome.wall_seconds,
               folder.string());
  return outcome.status == RunStatus::done ? exit_done : exit_interrupted;
}

}  // namespace driver::commands
