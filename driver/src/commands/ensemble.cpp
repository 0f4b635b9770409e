// SPDX-License-Identifier: Apache-2.0
#include "driver/ensemble.hpp"

#include <fmt/format.h>

#include "commands/commands.hpp"
#include "driver/progress.hpp"

namespace driver::commands {
namespace {

constexpr std::initializer_list<const char*> files_of_case{"ensemble.csv", "quantities.csv", "ensemble.json"};

void refuse_inputs_of(const std::filesystem::path& folder, const std::filesystem::path& file,
                      const std::vector<std::string>& overrides) {
  const auto inputs = input_files(file, overrides);
  refuse_inputs(folder / file.stem(), files_of_case, inputs);
  refuse_inputs(folder, {"effects.csv"}, inputs);
}

void print_quantities(const std::string& title, const EnsembleResult& result) {
  fmt::print("{}\n  {:28} {:>12} {:>12} {:>12} {:>12} {:>5}\n", title, "quantity", "mean", "std. error",
             "minimum", "maximum", "runs");
  for (const auto& [name, values] : result.quantities) {
    const Statistics s = statistics(values);
    fmt::print("  {:28} {:12.5g} {:12.3g} {:12.5g} {:12.5g} {:5}\n", name, s.mean, s.standard_error,
               s.minimum, s.maximum, s.count);
  }
}

void report(const std::string& title, const EnsembleResult& result, bool quiet) {
  if (!quiet) print_quantities(title, result);
  for (const auto& failure : result.failures)
    fmt::print(stderr, "gasjet: {}: failed run, left out: {}\n", title, failure);
  if (!quiet)
    for (const auto& warning : result.warnings) fmt::print(stderr, "warning: {}: {}\n", title, warning);
}

void print_effects(const std::vector<Effect>& list) {
  fmt::print("difference\n  {:28} {:>12} {:>12} {:>10}\n", "quantity", "difference", "std. errors", "");
  for (const Effect& e : list)
    fmt::print("  {:28} {:12.5g} {:12.3g} {:>10}\n", e.quantity, e.difference, e.standard_errors,
               e.decided() ? "decided" : "undecided");
}

void write_effects(const std::filesystem::path& file, const std::vector<Effect>& list) {
  std::ofstream csv(file);
  csv << "quantity,mean,standard_error,mean_against,standard_error_against,difference,standard_errors,"
         "decided\n";
  for (const Effect& e : list)
    csv << fmt::format("{},{},{},{},{},{},{},{}\n", e.quantity, e.with.mean, e.with.standard_error,
                       e.without.mean, e.without.standard_error, e.difference, e.standard_errors,
                       e.decided() ? "yes" : "no");
  csv.flush();
  if (!csv) throw WriteError(fmt::format("{}: write failed", file.string()));
}

}  // namespace

int ensemble(const EnsembleArguments& arguments) {
  const EnsembleOptions options{arguments.runs, arguments.amplitude, arguments.threads, arguments.quiet};
  const auto folder = arguments.out.empty() ? std::filesystem::path("results") /
                                                  ("ensemble_" + arguments.scene.file.stem().string())
                                            : arguments.out;
  if (!arguments.against.empty()) {
    if (arguments.against.stem() == arguments.scene.file.stem())
      throw CaseError(fmt::format("--against {}: needs another file name than the first case",
                                  arguments.against.string()));
    read_ensemble_scene(arguments.against, arguments.scene.overrides);
    refuse_inputs_of(folder, arguments.against, arguments.scene.overrides);
  }
  read_ensemble_scene(arguments.scene.file, arguments.scene.overrides);
  refuse_inputs_of(folder, arguments.scene.file, arguments.scene.overrides);
  prepare_output(folder, {"effects.csv"});
  prepare_output(folder / arguments.scene.file.stem(), files_of_case);
  if (!arguments.against.empty()) prepare_output(folder / arguments.against.stem(), files_of_case);
  catch_interrupt();
  const auto result = run_ensemble(arguments.scene.file, arguments.scene.overrides, options);
  write_ensemble(folder / arguments.scene.file.stem(), result,
                 provenance(arguments.scene.file, arguments.scene.overrides));
  report(arguments.scene.file.stem().string(), result, options.quiet);
  bool failed = !result.failures.empty();
  if (!arguments.against.empty() && !interrupted()) {
    const auto other = run_ensemble(arguments.against, arguments.scene.overrides, options);
    write_ensemble(folder / arguments.against.stem(), other,
                   provenance(arguments.against, arguments.scene.overrides));
    report(arguments.against.stem().string(), other, options.quiet);
    const auto list = effects(result, other);
    write_effects(folder / "effects.csv", list);
    if (!options.quiet) print_effects(list);
    failed = failed || !other.failures.empty();
  }
  if (interrupted()) return exit_interrupted;
  return failed ? exit_domain : exit_done;
}

}  // namespace driver::commands
