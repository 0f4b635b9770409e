// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <deque>

#include "base/progress.hpp"
#include "commands/command.hpp"
#include "input_files.hpp"
#include "many_runs/ensemble.hpp"
#include "results/load_scene.hpp"
#include "results/results.hpp"

namespace driver::commands {
namespace {

void refuse_inputs_of(const std::filesystem::path& folder, const std::filesystem::path& file,
                      const std::vector<std::string>& overrides) {
  const auto inputs = input_files(file, overrides);
  refuse_inputs(folder / file.stem(), inputs);
  refuse_inputs(folder, inputs);
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
    tell(fmt::format("gasjet: {}: failed run, left out: {}", title, failure));
  for (const auto& warning : result.warnings) tell(fmt::format("warning: {}: {}", title, warning));
}

void print_effects(const std::vector<Effect>& list) {
  fmt::print("difference\n  {:28} {:>12} {:>12} {:>8} {:>10}\n", "quantity", "difference", "std. errors",
             "needed", "");
  for (const Effect& e : list)
    fmt::print("  {:28} {:12.5g} {:12.3g} {:8.3g} {:>10}\n", e.quantity, e.difference, e.standard_errors,
               e.needed, e.decided() ? "decided" : "undecided");
  fmt::print("decided: more standard errors than needed, 5 from 16 runs of each case on, more by fewer\n");
}

std::string effects_text(const std::vector<Effect>& list) {
  std::string csv =
      "quantity,mean,standard_error,mean_against,standard_error_against,difference,standard_errors,decided\n";
  for (const Effect& e : list)
    csv += fmt::format("{},{},{},{},{},{},{},{}\n", e.quantity, e.with.mean, e.with.standard_error,
                       e.without.mean, e.without.standard_error, e.difference, e.standard_errors,
                       e.decided() ? "yes" : "no");
  return csv;
}

// One case of the command: its folder and the outcome of its runs.
struct Part {
  Part(const std::filesystem::path& case_file, const std::filesystem::path& out)
      : file(case_file), folder(out / case_file.stem(), "ensemble") {}
  std::filesystem::path file;
  ResultFolder folder;
  EnsembleResult result;
};

std::string id_of_cases(const std::vector<std::filesystem::path>& files, const EnsembleArguments& arguments) {
  std::deque<CaseDocument> documents;
  std::vector<const CaseDocument*> cases;
  for (const auto& file : files) {
    documents.emplace_back(file, arguments.scene.overrides);
    load_scene(documents.back());
    cases.push_back(&documents.back());
  }
  return id_of("ensemble",
               {fmt::format("{}", arguments.runs), fmt::format("{}", arguments.amplitude),
                fmt::format("{}", arguments.first_seed)},
               cases);
}

// Computes the runs of a share, in subfolders of the cases' folders.
int run_shares(const std::filesystem::path& path, const std::deque<EnsembleCase>& cases, Crew& crew,
               const EnsembleOptions& options, const Provenance& lines) {
  bool whole = true, failed = false;
  ResultFolder::require_free(path, "ensemble");
  for (std::size_t i = 0; i < cases.size() && whole; ++i) {
    const auto stem = cases[i].file.stem();
    const auto part = path / stem;
    ResultFolder::require_free(part, "ensemble");
    ResultFolder folder(part / shares_folder / options.share.name(), "ensemble");
    folder.begin(lines);
    const EnsembleResult share = run_ensemble(cases, i, options, crew, folder, part);
    whole = share.ended == share.asked;
    failed = failed || !share.failures.empty();
    folder.end(whole ? "whole" : "interrupted");  // never "done", which would remove the journal
    if (!options.quiet)
      fmt::print("{}: share {}: {} of {} runs have ended, {} not done\n", stem.string(), options.share.name(),
                 share.ended, share.asked, share.failures.size());
  }
  if (!whole) return tell_interrupted(path);
  return failed ? exit_domain : exit_done;
}

}  // namespace

int ensemble(const EnsembleArguments& arguments, const MakeCrew& make_crew) {
  const EnsembleOptions options{arguments.runs, arguments.amplitude, arguments.first_seed, arguments.quiet,
                                share_of(arguments.share)};
  const auto& overrides = arguments.scene.overrides;
  const auto path = arguments.out.empty() ? std::filesystem::path("results") /
                                                ("ensemble_" + arguments.scene.file.stem().string())
                                          : arguments.out;
  std::vector<std::filesystem::path> files{arguments.scene.file};
  if (!arguments.against.empty()) files.push_back(arguments.against);
  if (files.size() > 1 && files[0].stem() == files[1].stem())
    throw CaseError(fmt::format("--against {}: must have another file name than the first case",
                                arguments.against.string()));
  std::deque<EnsembleCase> cases;
  for (const auto& file : files) {
    require_file(file);
    cases.push_back(read_ensemble_case(file, overrides));
    refuse_inputs_of(path, file, overrides);
    tell_warnings(cases.back().scene);
  }
  const std::string id = id_of_cases(files, arguments);
  for (const auto& file : files) shares_in(path / file.stem(), id);
  const auto crew = make_crew(id, ensemble_work(cases, arguments.threads), arguments.threads);
  if (!crew) return exit_done;
  if (options.share.count > 1) {
    catch_interrupt();
    return run_shares(path, cases, *crew, options, provenance(arguments.scene.file, overrides, id));
  }
  ResultFolder all(path, "ensemble");
  std::deque<Part> parts;
  for (std::size_t i = 0; i < files.size(); ++i) parts.emplace_back(files[i], path);
  catch_interrupt();
  all.begin(provenance(arguments.scene.file, overrides, id));
  for (Part& part : parts) part.folder.begin(provenance(part.file, overrides, id));
  bool failed = false;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Part& part = parts[i];
    part.result.asked = options.runs;
    if (!interrupted()) part.result = run_ensemble(cases, i, options, *crew, part.folder, part.folder.path());
    write_ensemble(part.folder, part.result);
    report(part.file.stem().string(), part.result, options.quiet);
    failed = failed || !part.result.failures.empty();
  }
  const bool done =
      std::ranges::all_of(parts, [](const Part& part) { return part.result.ended == part.result.asked; });
  if (parts.size() > 1 && done) {
    const auto list = effects(parts[0].result, parts[1].result);
    all.write("effects.csv", comment_lines(all.lines()) + effects_text(list));
    if (!options.quiet) print_effects(list);
  }
  // All at once, so that files that refer to each other are of one run.
  const char* status = done ? "done" : "interrupted";
  for (Part& part : parts) part.folder.end(status);
  all.end(status);
  if (done)
    for (const Part& part : parts) remove_shares(part.folder);
  if (!done) return tell_interrupted(path);
  return failed ? exit_domain : exit_done;
}

}  // namespace driver::commands
