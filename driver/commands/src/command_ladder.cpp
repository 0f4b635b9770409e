// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "argument_list.hpp"
#include "base/number_text.hpp"
#include "base/progress.hpp"
#include "commands/command.hpp"
#include "input_files.hpp"
#include "many_runs/ladder.hpp"
#include "many_runs/quantities.hpp"
#include "results/load_scene.hpp"
#include "results/results.hpp"

namespace driver::commands {
namespace {

double read_tolerance(const std::string& text) {
  const auto value = fraction_of(text);
  if (!value || !(*value > 0.0 && *value <= 1.0))
    throw CaseError(
        fmt::format("--tolerance {}: is not a share above 0 and up to 1, such as 0.02 or 2%", text));
  return *value;
}

// Value in per cent of the reference, over the part where the quantity is judged.
double per_cent(const LadderResult& result, double value) {
  return 100.0 * value / std::abs(result.reference.value - result.zero);
}

void print_scene(const LadderResult& result, const LadderOptions& options) {
  const double tolerance = 100.0 * options.tolerance;
  if (result.chaotic)
    fmt::print("seeds of {:g} m scatter {} by {:.3g}, {:g} % of it would be {:.3g}: means of {}{} runs\n",
               default_amplitude, result.quantity, result.spread, tolerance,
               options.tolerance * std::abs(result.reference.value - result.zero), options.runs,
               options.most_runs > options.runs ? fmt::format(" to {}", options.most_runs) : "");
  else if (result.rungs.front().can_be_perturbed)
    fmt::print("not chaotic: seeds of {:g} m scatter {} by {:.3g} only: single runs\n", default_amplitude,
               result.quantity, result.spread);
  const LadderReference& reference = result.reference;
  fmt::print("reference: {:.8g}, standard error {:.2g}, uncertainty {:.2g}\n", reference.value,
             reference.standard_error, reference.uncertainty);
  if (result.zero != 0.0) fmt::print("  counted from {:g}, the ambient pressure\n", result.zero);
  for (const auto& [axis, rest] : reference.remainders)
    fmt::print("  beyond that of the finest {}: {:.2g}, uncertain by {:.2g}, {}\n", axis, rest.correction,
               rest.uncertainty,
               rest.order ? fmt::format("order {:.2f} seen", *rest.order) : "no order seen");
}

void print_rungs(const LadderResult& result) {
  fmt::print("\n  {:28} {:>12} {:>10} {:>9} {:>9} {:>10} {:>8}  {}\n", "rung", "value", "error", "s.e.",
             "error %", "CPU s", "cost", "");
  const double full_cost = result.rungs.front().cpu_seconds;
  for (const LadderRung& rung : result.rungs) {
    if (!rung.failure.empty()) {
      fmt::print("  {:28} {}\n", rung.name, rung.failure);
      continue;
    }
    fmt::print("  {:28} {:12.6g} {:10.3g} {:9.2g} {:9.3g} {:10.3g} {:8.3f}  {}\n", rung.name, rung.value.mean,
               rung.error, rung.standard_error, per_cent(result, rung.error), rung.cpu_seconds,
               rung.cpu_seconds / full_cost, verdict_name(rung.verdict));
  }
  for (const auto& reason : result.plan.left_out) fmt::print("  left out: {}\n", reason);
}

void print_changes(const LadderResult& result) {
  fmt::print("\nwhat each does to the full case\n  {:28} {:>12} {:>9} {:>9}\n", "", "change", "s.e.",
             "change %");
  for (const LadderRung& rung : result.rungs) {
    const bool no_membrane = result.plan.no_membrane && !rung.can_be_perturbed;
    if (!(rung.axis || no_membrane) || !rung.failure.empty()) continue;
    const Change change = change_of(result, rung);
    fmt::print("  {:28} {:12.4g} {:9.2g} {:9.3g}\n", rung.name, change.value, change.standard_error,
               per_cent(result, change.value));
  }
}

void print_verdict(const LadderResult& result, const LadderOptions& options,
                   const std::filesystem::path& folder) {
  fmt::print("\n");
  if (!result.cheapest) {
    fmt::print(
        "undecided: no rung is known to be within {:g} %; use more --runs, --finer 2, a wider --tolerance, "
        "or --hold for axes that do not matter\n",
        100.0 * options.tolerance);
    return;
  }
  const LadderRung& best = result.rungs[*result.cheapest];
  for (const Verdict verdict : {Verdict::undecided, Verdict::on_the_bound}) {
    std::vector<std::string> cheaper;
    for (const LadderRung& rung : result.rungs)
      if (rung.verdict == verdict && rung.cpu_seconds < best.cpu_seconds) cheaper.push_back(rung.differs);
    if (!cheaper.empty())
      fmt::print("cheaper, but {}: {}\n", verdict_name(verdict), fmt::join(cheaper, "; "));
  }
  fmt::print("cheapest within {:g} %: {}, {:.3g} s of CPU ({:.2g} of the full case); written to {}\n",
             100.0 * options.tolerance, best.differs, best.cpu_seconds,
             best.cpu_seconds / result.rungs.front().cpu_seconds, (folder / "cheapest.toml").string());
}

std::string end_of_band(const LadderResult& result, double change, const std::string& rung) {
  return fmt::format("{:+.3g} ({:+.3g} %, {})", change, per_cent(result, change), rung);
}

// What the model itself may be off by is no error of a rung.
void print_model(const LadderResult& result, const LadderOptions& options) {
  if (!result.model) return;
  const ModelBand& band = *result.model;
  std::vector<std::string> assumptions;
  for (const LadderAxis& axis : result.plan.axes)
    if (axis.kind == AxisKind::model) assumptions.push_back(axis.name);
  fmt::print("the model's own band, by {} of the jet: {} to {}\n", fmt::join(assumptions, ", "),
             end_of_band(result, band.low, band.lowest), end_of_band(result, band.high, band.highest));
  if (result.cheapest && !band.cheapest_stands)
    fmt::print("within {:g} % of this model; with its band that verdict falls: know these first\n",
               100.0 * options.tolerance);
}

void print(const LadderResult& result, const LadderOptions& options, const std::filesystem::path& folder) {
  print_scene(result, options);
  print_rungs(result);
  print_changes(result);
  print_verdict(result, options, folder);
  print_model(result, options);
}

// The options that affect the results.
std::vector<std::string> options_of(const LadderOptions& options) {
  return {options.quantity, fmt::format("{}", options.tolerance),
          fmt::format("{}", fmt::join(options.hold, ",")), fmt::format("{}", options.runs),
          fmt::format("{} {} {}", options.most_runs, options.error_rate, options.finer)};
}

void draw(ResultFolder& folder, const LadderResult& result, const LadderOptions& options) {
  if (const auto problem = draw_ladder(folder, result, options); !problem.empty())
    tell("gasjet: no chart: " + problem);
  else if (!options.quiet)
    fmt::print("chart: {}\n", (folder.path() / "ladder.svg").string());
}

}  // namespace

int ladder(const LadderArguments& arguments, const MakeCrew& make_crew) {
  LadderOptions options{arguments.quantity, read_tolerance(arguments.tolerance), names_of(arguments.hold),
                        arguments.runs, arguments.quiet};
  options.most_runs = arguments.most_runs;
  options.error_rate = arguments.error_rate;
  options.finer = arguments.finer;
  const auto& file = arguments.scene.file;
  const auto& overrides = arguments.scene.overrides;
  const auto path = arguments.out.empty() ? std::filesystem::path("results") /
                                                ("ladder_" + arguments.scene.file.stem().string())
                                          : arguments.out;
  require_file(file);
  const auto plan = plan_ladder(file, overrides, options.quantity, options.hold, options.finer);
  CaseDocument document(file, overrides);
  Scene scene = load_scene(document);
  tell_warnings(scene);
  refuse_inputs(path, document.files());
  const std::string id = id_of("ladder", options_of(options), {&document});
  const auto crew =
      make_crew(id, ladder_work(file, overrides, quantity_name(scene, options.quantity), arguments.threads),
                arguments.threads);
  if (!crew) return exit_done;
  ResultFolder folder(path, "ladder");
  catch_interrupt();
  folder.begin(provenance(file, overrides, id));
  const LadderResult result = run_ladder(file, overrides, plan, options, *crew, &folder);
  const bool partial = interrupted();
  write_ladder(folder, result, file, overrides, options, partial);
  if (partial) {
    folder.end("interrupted");
    return tell_interrupted(path / "ladder.csv");
  }
  if (result.reason.empty() && !options.quiet) print(result, options, path);
  if (result.reason.empty())
    draw(folder, result, options);
  else
    tell(fmt::format("gasjet: undecided: {}", result.reason));
  folder.end("done");
  return result.reason.empty() ? exit_code(result.verdict) : exit_undecided;
}

}  // namespace driver::commands
