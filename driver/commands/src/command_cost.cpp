// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "base/json_head.hpp"
#include "base/progress.hpp"
#include "commands/command.hpp"
#include "input_files.hpp"
#include "many_runs/cost.hpp"
#include "results/load_scene.hpp"
#include "results/results.hpp"

namespace driver::commands {
namespace {

void print(const CostArguments& arguments, const CostResult& result, const Provenance& lines) {
  fmt::print("{}", arguments.format == "json" ? cost_json(result, lines) : cost_text(result));
}

void write(ResultFolder& folder, const CostResult& result) {
  const std::string head = comment_lines(folder.lines());
  folder.write("cost.csv", head + cost_csv(result));
  folder.write("cost.json", cost_json(result, folder.lines()));
  folder.write("cost.txt", head + cost_text(result));
}

}  // namespace

int cost(const CostArguments& arguments) {
  const auto& [file, overrides] = arguments.scene;
  const CostOptions options{arguments.runs, arguments.threads, arguments.quiet};
  require_file(file);
  CaseDocument document(file, overrides);
  Scene scene = load_scene(document);
  tell_warnings(scene);
  std::optional<ResultFolder> folder;
  Provenance lines = provenance(
      file, overrides, id_of("cost", {fmt::format("{} {}", options.runs, options.threads)}, {&document}));
  catch_interrupt();
  if (!arguments.out.empty()) {
    refuse_inputs(arguments.out, document.files());
    folder.emplace(arguments.out, "cost");
    folder->begin(lines);
    lines = folder->lines();
  }
  const CostResult result = measure_cost(file, overrides, options);
  if (folder) write(*folder, result);
  if (folder) folder->end(interrupted() ? "interrupted" : "done");
  print(arguments, result, lines);
  if (interrupted()) {
    tell(fmt::format("gasjet: interrupted after {} of {} runs of each",
                     result.variants.front().cpu_seconds.size(), options.runs));
    return exit_interrupted;
  }
  bool failed = false;
  for (const CostVariant& variant : result.variants)
    if (!variant.failure.empty()) {
      tell(fmt::format("gasjet: {}: {}", variant.name, variant.failure));
      failed = true;
    }
  return failed ? exit_domain : exit_done;
}

}  // namespace driver::commands
