// SPDX-License-Identifier: Apache-2.0
#include "driver/run.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "commands/commands.hpp"
#include "driver/progress.hpp"

namespace driver::commands {

int run(const RunArguments& arguments) {
  CaseDocument document(arguments.scene.file, arguments.scene.overrides);
  const Scene scene = read_scene(document);
  if (!arguments.quiet)
    for (const auto& warning : scene.warnings) fmt::print(stderr, "warning: {}\n", warning);
  const auto folder =
      arguments.out.empty() ? std::filesystem::path("results") / arguments.scene.file.stem() : arguments.out;
  refuse_inputs(folder, {"history.csv", "energy.csv", "summary.json"}, document.files());
  catch_interrupt();
  const auto outcome =
      run_to_folder(scene, folder, provenance(arguments.scene.file, arguments.scene.overrides),
                    {arguments.quiet, arguments.threads});
  if (!outcome.warning.empty() && !arguments.quiet) fmt::print(stderr, "warning: {}\n", outcome.warning);
  if (outcome.status == RunStatus::inaccurate) {
    fmt::print(stderr, "gasjet: inaccurate: {}\nResults up to the end are in {}\n", outcome.message,
               folder.string());
    return exit_domain;
  }
  if (outcome.status == RunStatus::failed) {
    fmt::print(stderr, "gasjet: {}\nResults up to there are in {}\n", outcome.message, folder.string());
    return exit_domain;
  }
  if (!arguments.quiet)
    fmt::print("{}: {} in {:.2f} s, results in {}\n", scene.name,
               outcome.status == RunStatus::done ? "done" : "interrupted", outcome.wall_seconds,
               folder.string());
  return outcome.status == RunStatus::done ? exit_done : exit_interrupted;
}

}  // namespace driver::commands
