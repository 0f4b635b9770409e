// SPDX-License-Identifier: Apache-2.0
#include "many_runs/ensemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/progress.hpp"
#include "case_settings.hpp"
#include "many_runs/quantities.hpp"
#include "results/load_scene.hpp"
#include "run_jobs.hpp"

namespace driver {
namespace {

// Column `c` of the history at `time`, linear between the recorded levels.
double column_at(const std::vector<std::vector<double>>& rows, double time, std::size_t c) {
  const auto after =
      std::ranges::lower_bound(rows, time, {}, [](const std::vector<double>& row) { return row.front(); });
  if (after == rows.end()) return rows.back()[c];
  if (after == rows.begin()) return rows.front()[c];
  const auto &a = *(after - 1), &b = *after;
  const double part = (time - a.front()) / (b.front() - a.front());
  return a[c] + part * (b[c] - a[c]);
}

void collect_rows(const Scene& scene, const std::vector<const RunRecord*>& runs, EnsembleResult& result) {
  const auto names = row_names(scene);
  result.columns.assign(names.begin() + 1, names.end());
  const auto count = static_cast<long>(std::llround(scene.time.end / scene.output.history_every));
  std::vector<double> values(runs.size());
  for (long i = 0; i <= count; ++i) {
    EnsembleRow row{std::min(scene.time.end, static_cast<double>(i) * scene.output.history_every), {}};
    for (std::size_t c = 1; c < names.size(); ++c) {
      for (std::size_t m = 0; m < runs.size(); ++m) values[m] = column_at(runs[m]->rows, row.time_s, c);
      row.values.push_back(statistics(values));
    }
    result.rows.push_back(std::move(row));
  }
}

constexpr std::size_t most_singles = 16, most_single_rows = 201;

void collect_singles(const std::vector<const RunRecord*>& runs, int first_seed, EnsembleResult& result) {
  const std::size_t count = result.rows.size();
  result.singles_every = std::max<std::size_t>(1, (count + most_single_rows - 3) / (most_single_rows - 1));
  for (const RunRecord* run : runs) {
    if (result.singles.size() == most_singles) return;
    SingleRun& single = result.singles.emplace_back();
    single.seed = first_seed + static_cast<int>(run->number);
    for (std::size_t i = 0; i < count; i += result.singles_every) {
      auto& row = single.rows.emplace_back();
      for (std::size_t c = 1; c <= result.columns.size(); ++c)
        row.push_back(column_at(run->rows, result.rows[i].time_s, c));
    }
  }
}

void collect_quantities(const Scene& scene, const std::vector<const RunRecord*>& runs,
                        EnsembleResult& result) {
  const auto names = quantity_names(scene);
  for (std::size_t i = 0; i < names.size(); ++i)
    for (const RunRecord* run : runs)
      if (const auto& value = run->values[i]) result.quantities[names[i]].push_back(*value);
}

RunShape shape_of(const EnsembleCase& one, const EnsembleOptions& options) {
  return {options.runs, quantity_names(one.scene).size(), row_names(one.scene).size()};
}

// A job for each run of the share that the journal does not have.
void compute(const EnsembleCase& one, std::size_t place, const EnsembleOptions& options, Crew& crew,
             RunJournal& journal) {
  const std::string name = one_line(one.scene.name);
  tell_start(name, journal, options.quiet);
  std::vector<RunJob> jobs;
  for (int run = 0; run < options.runs; ++run)
    if (options.share.has(run) && !journal.find(run))
      jobs.push_back({.place = place,
                      .name = name,
                      .overrides = {},
                      .amplitude = options.amplitude,
                      .runs = {{run, options.first_seed + run}}});
  compute_runs(crew, batch_of(name, options.quiet, std::move(jobs)), journal);
}

EnsembleResult result_of(const Scene& scene, const RunJournal::Runs& runs, const EnsembleOptions& options) {
  EnsembleResult result;
  for (int run = 0; run < options.runs; ++run) result.asked += options.share.has(run);
  std::vector<const RunRecord*> done;
  for (const auto& [number, run] : runs) {
    if (!options.share.has(number)) continue;
    ++result.ended;
    if (run.is_done()) done.push_back(&run);
    if (!run.message.empty()) result.failures.push_back(run.message);
    if (!run.warning.empty()) result.warnings.push_back(run.warning);
  }
  if (done.empty()) return result;
  collect_rows(scene, done, result);
  collect_singles(done, options.first_seed, result);
  collect_quantities(scene, done, result);
  return result;
}

}  // namespace

EnsembleCase read_ensemble_case(const std::filesystem::path& file,
                                const std::vector<std::string>& overrides) {
  CaseDocument document(file, overrides);
  EnsembleCase one{file, overrides, load_scene(document)};
  if (!one.scene.bag)
    throw CaseError(
        fmt::format("{}: an ensemble perturbs the nodes of a membrane, the scene has none", file.string()));
  for (const auto& text : overrides)
    if (text.starts_with("membrane.perturbation"))
      throw CaseError(fmt::format("--set {}: the ensemble sets the perturbation itself (--amplitude)", text));
  return one;
}

CrewWork ensemble_work(const std::deque<EnsembleCase>& cases, int workers) {
  std::vector<RunCase> list;
  for (const EnsembleCase& one : cases)
    list.push_back({[file = one.file, overrides = one.overrides](const auto& more) {
                      return load_variant(file, overrides, more);
                    },
                    quantity_names(one.scene), true, false});
  return run_work(std::move(list), workers);
}

EnsembleResult run_ensemble(const std::deque<EnsembleCase>& cases, std::size_t place,
                            const EnsembleOptions& options, Crew& crew, ResultFolder& folder,
                            const std::filesystem::path& whole) {
  RunJournal journal(shape_of(cases[place], options));
  journal.read_shares(whole, folder.run());
  journal.open(folder);
  compute(cases[place], place, options, crew, journal);
  return result_of(cases[place].scene, journal.runs(), options);
}

EnsembleResult run_ensemble(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                            const EnsembleOptions& options, int threads) {
  std::deque<EnsembleCase> cases;
  cases.push_back(read_ensemble_case(file, overrides));
  RunJournal journal(shape_of(cases.front(), options));
  compute(cases.front(), 0, options, *thread_crew(ensemble_work(cases, threads), threads), journal);
  return result_of(cases.front().scene, journal.runs(), options);
}

}  // namespace driver
