// SPDX-License-Identifier: Apache-2.0
#include "driver/ensemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <nlohmann/json.hpp>

#include "driver/progress.hpp"
#include "ensemble/member.hpp"
#include "step/stages.hpp"

namespace driver {
namespace {

// Column `c` of the history at `time`, linear between the recorded levels.
double interpolate(const std::vector<std::vector<double>>& rows, double time, std::size_t c) {
  const auto after =
      std::ranges::lower_bound(rows, time, {}, [](const std::vector<double>& row) { return row.front(); });
  if (after == rows.end()) return rows.back()[c];
  if (after == rows.begin()) return rows.front()[c];
  const auto &a = *(after - 1), &b = *after;
  const double part = (time - a.front()) / (b.front() - a.front());
  return a[c] + part * (b[c] - a[c]);
}

void collect_rows(const Scene& scene, const std::vector<const Member*>& members, EnsembleResult& result) {
  const auto columns = history_columns(scene);
  for (std::size_t c = 1; c < columns.size(); ++c) result.columns.push_back(columns[c].name);
  const auto count = static_cast<long>(std::llround(scene.time.end / scene.output.history_every));
  std::vector<double> values(members.size());
  for (long i = 0; i <= count; ++i) {
    EnsembleRow row{std::min(scene.time.end, static_cast<double>(i) * scene.output.history_every), {}};
    for (std::size_t c = 1; c < columns.size(); ++c) {
      for (std::size_t m = 0; m < members.size(); ++m)
        values[m] = interpolate(members[m]->rows, row.time_s, c);
      row.values.push_back(statistics(values));
    }
    result.rows.push_back(std::move(row));
  }
}

void collect_quantities(const Scene& scene, const std::vector<const Member*>& members,
                        EnsembleResult& result) {
  const auto names = quantity_names(scene);
  for (std::size_t i = 0; i < names.size(); ++i)
    for (const Member* m : members)
      if (const auto& value = m->quantities[i]) result.quantities[names[i]].push_back(*value);
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
  Scene scene = read_scene(document);
  if (!scene.bag)
    throw CaseError(
        fmt::format("{}: an ensemble perturbs the nodes of a membrane, the scene has none", file.string()));
  for (const auto& text : overrides)
    if (text.starts_with("membrane.perturbation"))
      throw CaseError(fmt::format("--set {}: the ensemble sets the perturbation itself (--amplitude)", text));
  return scene;
}

EnsembleResult run_ensemble(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                            const EnsembleOptions& options) {
  const Scene scene = read_ensemble_scene(file, overrides);
  std::vector<Member> members(static_cast<std::size_t>(options.runs));
  std::atomic<int> finished = 0;
  std::mutex progress_lock;
  Progress progress(scene.name, options.runs, options.quiet);
  // Runs side by side, each serial inside.
  Executor(options.threads).for_each(options.runs, [&](int i) {
    if (interrupted()) return;
    CaseDocument document(file, perturbed(overrides, options.amplitude, i + 1));
    members[static_cast<std::size_t>(i)] = run_member(read_scene(document));
    const std::lock_guard<std::mutex> guard(progress_lock);
    progress.update(++finished, fmt::format("run {} of {}", finished.load(), options.runs));
  });
  EnsembleResult result;
  std::vector<const Member*> complete;
  for (const Member& m : members) {
    if (m.outcome.status == RunStatus::done && !m.rows.empty())
      complete.push_back(&m);
    else if (!m.outcome.message.empty())
      result.failures.push_back(m.outcome.message);
    if (!m.outcome.warning.empty()) result.warnings.push_back(m.outcome.warning);
  }
  if (complete.empty()) return result;
  collect_rows(scene, complete, result);
  collect_quantities(scene, complete, result);
  return result;
}

void write_ensemble(const std::filesystem::path& folder, const EnsembleResult& result,
                    const Provenance& lines) {
  prepare_output(folder);
  std::ofstream csv(folder / "ensemble.csv");
  for (const auto& [key, value] : lines) csv << "# " << key << ": " << value << '\n';
  csv << "time_s";
  for (const auto& name : result.columns) csv << ',' << name << "_mean," << name << "_standard_error";
  csv << '\n';
  for (const EnsembleRow& row : result.rows) {
    csv << fmt::format("{}", row.time_s);
    for (const auto& s : row.values) csv << fmt::format(",{},{}", s.mean, s.standard_error);
    csv << '\n';
  }
  std::ofstream table(folder / "quantities.csv");
  table << "quantity,mean,standard_error,minimum,maximum,runs\n";
  nlohmann::ordered_json json;
  for (const auto& [name, values] : result.quantities) {
    const Statistics s = statistics(values);
    table << fmt::format("{},{},{},{},{},{}\n", name, s.mean, s.standard_error, s.minimum, s.maximum,
                         s.count);
    json["quantities"][name] = {{"mean", s.mean},       {"standard_error", s.standard_error},
                                {"minimum", s.minimum}, {"maximum", s.maximum},
                                {"runs", s.count},      {"values", values}};
  }
  json["failures"] = result.failures;
  if (!result.warnings.empty()) json["warnings"] = result.warnings;
  for (const auto& [key, value] : lines) json["build"][key] = value;
  std::ofstream summary(folder / "ensemble.json");
  summary << json.dump(2) << '\n';
  csv.flush();
  table.flush();
  summary.flush();
  if (!csv || !table || !summary) throw WriteError(fmt::format("{}: write failed", folder.string()));
}

std::vector<Effect> effects(const EnsembleResult& with, const EnsembleResult& without) {
  std::vector<Effect> list;
  for (const auto& [name, values] : with.quantities) {
    const auto other = without.quantities.find(name);
    if (other == without.quantities.end()) continue;
    Effect effect{name, statistics(values), statistics(other->second), 0.0, 0.0};
    effect.difference = effect.with.mean - effect.without.mean;
    const double error = std::hypot(effect.with.standard_error, effect.without.standard_error);
    effect.standard_errors = error > 0.0 ? std::abs(effect.difference) / error : 0.0;
    list.push_back(effect);
  }
  return list;
}

}  // namespace driver
