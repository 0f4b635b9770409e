// SPDX-License-Identifier: Apache-2.0
#include "many_runs/ensemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <any>
#include <cmath>
#include <elementary/hypot.hpp>
#include <sstream>

#include "base/journal.hpp"
#include "base/progress.hpp"
#include "compare/students_t.hpp"
#include "engine/stages.hpp"
#include "ensemble/member.hpp"
#include "results/load_scene.hpp"

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

void collect_rows(const Scene& scene, const std::vector<const Member*>& members, EnsembleResult& result) {
  const auto names = row_names(scene);
  result.columns.assign(names.begin() + 1, names.end());
  const auto count = static_cast<long>(std::llround(scene.time.end / scene.output.history_every));
  std::vector<double> values(members.size());
  for (long i = 0; i <= count; ++i) {
    EnsembleRow row{std::min(scene.time.end, static_cast<double>(i) * scene.output.history_every), {}};
    for (std::size_t c = 1; c < names.size(); ++c) {
      for (std::size_t m = 0; m < members.size(); ++m) values[m] = column_at(members[m]->rows, row.time_s, c);
      row.values.push_back(statistics(values));
    }
    result.rows.push_back(std::move(row));
  }
}

constexpr std::size_t most_singles = 16, most_single_rows = 201;

void collect_singles(const std::vector<std::pair<int, const Member*>>& runs, EnsembleResult& result) {
  const std::size_t count = result.rows.size();
  result.singles_every = std::max<std::size_t>(1, (count + most_single_rows - 3) / (most_single_rows - 1));
  for (const auto& [seed, member] : runs) {
    if (result.singles.size() == most_singles) return;
    SingleRun& single = result.singles.emplace_back();
    single.seed = seed;
    for (std::size_t i = 0; i < count; i += result.singles_every) {
      auto& row = single.rows.emplace_back();
      for (std::size_t c = 1; c <= result.columns.size(); ++c)
        row.push_back(column_at(member->rows, result.rows[i].time_s, c));
    }
  }
}

void collect_quantities(const Scene& scene, const std::vector<const Member*>& members,
                        EnsembleResult& result) {
  const auto names = quantity_names(scene);
  for (std::size_t i = 0; i < names.size(); ++i)
    for (const Member* m : members)
      if (const auto& value = m->quantities[i]) result.quantities[names[i]].push_back(*value);
}

std::string key_of(int seed) {
  return fmt::format("seed {}", seed);
}

std::vector<Member> run_members(const EnsembleScene& ensemble, const EnsembleOptions& options,
                                ResultFolder* folder) {
  const Scene& scene = ensemble.scene;
  const std::string name = one_line(scene.name);
  std::vector<Member> members(static_cast<std::size_t>(options.runs));
  Journal journal(folder);
  std::vector<int> missing;
  std::vector<std::string> jobs;
  int before = 0;
  for (int i = 0; i < options.runs; ++i) {
    if (!options.share.has(i)) continue;
    const int seed = options.first_seed + i;
    if (auto kept = member_of(scene, journal.find(key_of(seed)))) {
      members[static_cast<std::size_t>(i)] = std::move(*kept);
      ++before;
    } else {
      missing.push_back(i);
      jobs.push_back(fmt::format("{} {}", ensemble.number, seed));
    }
  }
  if (before > 0 && !options.quiet)
    tell(fmt::format("{}: goes on after {} runs that are done", name, before));
  compute_jobs(name, ensemble.crew, jobs, options.quiet, [&](std::size_t job, CrewResult result) {
    const int i = missing[job];
    journal.add(key_of(options.first_seed + i), result.line);
    Member& member = members[static_cast<std::size_t>(i)];
    if (auto* known = std::any_cast<Member>(&result.object)) {
      member = std::move(*known);
    } else {
      const auto json = nlohmann::json::parse(result.line);
      member = member_of(scene, &json).value();
    }
  });
  return members;
}

EnsembleResult result_of(const Scene& scene, const std::vector<Member>& members,
                         const EnsembleOptions& options) {
  EnsembleResult result;
  result.asked = options.runs;
  std::vector<const Member*> complete;
  std::vector<std::pair<int, const Member*>> seeds;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Member& m = members[i];
    if (has_ended(m)) ++result.ended;
    if (m.outcome.status == RunStatus::done && !m.rows.empty()) {
      complete.push_back(&m);
      seeds.emplace_back(options.first_seed + static_cast<int>(i), &m);
    } else if (!m.outcome.message.empty()) {
      result.failures.push_back(m.outcome.message);
    }
    if (!m.outcome.warning.empty()) result.warnings.push_back(m.outcome.warning);
  }
  if (complete.empty()) return result;
  collect_rows(scene, complete, result);
  collect_singles(seeds, result);
  collect_quantities(scene, complete, result);
  return result;
}

// Of each case's runs, squared: with no scatter at all on one side the other's freedom counts.
double welch_freedom(const Statistics& a, const Statistics& b) {
  const double va = a.standard_error * a.standard_error, vb = b.standard_error * b.standard_error;
  return (va + vb) * (va + vb) / (va * va / (a.count - 1) + vb * vb / (b.count - 1));
}

double needed_standard_errors(const Statistics& a, const Statistics& b) {
  constexpr double many_runs = 5.0, freedom_of_16_runs = 15.0;
  if (std::min(a.count, b.count) < 2) return HUGE_VAL;
  if (a.standard_error == 0.0 && b.standard_error == 0.0) return many_runs;
  const double chance = cdf(complement(StudentsT(freedom_of_16_runs), many_runs));
  return std::max(many_runs, quantile(complement(StudentsT(welch_freedom(a, b)), chance)));
}

}  // namespace

Statistics statistics(const std::vector<double>& values) {
  Statistics s;
  s.count = static_cast<int>(values.size());
  if (values.empty()) return s;
  const double n = static_cast<double>(values.size());
  for (const double v : values) s.mean += v / n;
  double squares = 0.0;
  for (const double v : values) squares += (v - s.mean) * (v - s.mean);
  s.standard_error = values.size() > 1 ? std::sqrt(squares / (n - 1.0) / n) : 0.0;
  s.minimum = *std::min_element(values.begin(), values.end());
  s.maximum = *std::max_element(values.begin(), values.end());
  return s;
}

Scene read_ensemble_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  CaseDocument document(file, overrides);
  Scene scene = load_scene(document);
  if (!scene.bag)
    throw CaseError(
        fmt::format("{}: an ensemble perturbs the nodes of a membrane, the scene has none", file.string()));
  for (const auto& text : overrides)
    if (text.starts_with("membrane.perturbation"))
      throw CaseError(fmt::format("--set {}: the ensemble sets the perturbation itself (--amplitude)", text));
  return scene;
}

CrewWork ensemble_work(const std::deque<Scene>& scenes, double amplitude) {
  return [&scenes, amplitude](const std::string& job, const std::function<void(CrewResult)>& emit) {
    std::istringstream text(job);
    std::size_t number = 0;
    int seed = 0;
    text >> number >> seed;
    Scene scene = scenes.at(number);
    displace_nodes(scene, amplitude, seed);
    Member member = run_member(scene);
    if (!has_ended(member)) return;
    std::string line = line_of(member);
    emit({std::move(line), std::move(member)});
  };
}

ShareOutcome run_ensemble_share(const EnsembleScene& scene, const EnsembleOptions& options,
                                ResultFolder& folder) {
  const auto members = run_members(scene, options, &folder);
  ShareOutcome share;
  for (int i = 0; i < options.runs; ++i) {
    if (!options.share.has(i)) continue;
    const Member& member = members[static_cast<std::size_t>(i)];
    ++share.asked;
    if (has_ended(member)) ++share.ended;
    if (has_ended(member) && member.outcome.status != RunStatus::done) ++share.failed;
  }
  return share;
}

EnsembleResult run_ensemble(const EnsembleScene& scene, const EnsembleOptions& options,
                            ResultFolder& folder) {
  return result_of(scene.scene, run_members(scene, options, &folder), options);
}

EnsembleResult run_ensemble(const Scene& scene, const EnsembleOptions& options, int threads) {
  const std::deque<Scene> scenes{scene};
  const auto crew = thread_crew(ensemble_work(scenes, options.amplitude), threads);
  return result_of(scene, run_members({scenes.front(), *crew, 0}, options, nullptr), options);
}

std::vector<Effect> effects(const EnsembleResult& with, const EnsembleResult& without) {
  std::vector<Effect> list;
  for (const auto& [name, values] : with.quantities) {
    const auto other = without.quantities.find(name);
    if (other == without.quantities.end()) continue;
    Effect effect{name, statistics(values), statistics(other->second)};
    effect.difference = effect.with.mean - effect.without.mean;
    const double error = elementary::hypot(effect.with.standard_error, effect.without.standard_error);
    if (effect.difference != 0.0) effect.standard_errors = std::abs(effect.difference) / error;
    effect.needed = needed_standard_errors(effect.with, effect.without);
    list.push_back(effect);
  }
  return list;
}

}  // namespace driver
