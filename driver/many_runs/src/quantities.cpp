// SPDX-License-Identifier: Apache-2.0
#include "many_runs/quantities.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/case_reader.hpp"
#include "engine/channel_filter.hpp"
#include "engine/columns.hpp"
#include "engine/scene_features.hpp"
#include "engine/stage_clock.hpp"
#include "results/acceleration_record.hpp"

namespace driver {
namespace {

struct Quantity {
  const char* name;
  bool (*when)(const Scene&);
  std::optional<double> (*value)(const State&, const VectorSignal& acceleration);
};

using At = const State&;
using Signal = const VectorSignal&;

std::optional<double> first_contact(At now, Signal) {
  if (now.peaks.first_contact < 0.0) return std::nullopt;
  return now.peaks.first_contact;
}

std::optional<double> filtered(At, Signal signal) {
  return filtered_peak(signal, impactor_channel_class);
}

// clang-format off
constexpr Quantity kQuantities[] = {
  {"peak_pressure_Pa", has::volume, [](At now, Signal) { return std::optional(now.peaks.pressure); }},
  {"peak_volume_m3", has::volume, [](At now, Signal) { return std::optional(now.peaks.volume); }},
  {"final_angle_rad", has::pendulum, [](At now, Signal) { return std::optional(now.level.pendulum_angle); }},
  {"peak_cg_acceleration_m_s2", has::pendulum, [](At now, Signal) { return std::optional(now.peaks.cg_acceleration); }},
  {"peak_cg_acceleration_cfc180_m_s2", has::pendulum, filtered},
  {"peak_impactor_displacement_m", has::body, [](At now, Signal) { return std::optional(now.peaks.displacement); }},
  {"peak_impactor_acceleration_m_s2", has::body, [](At now, Signal) { return std::optional(now.peaks.acceleration); }},
  {"peak_impactor_acceleration_cfc180_m_s2", has::body, filtered},
  {"hic15", has::body, [](At, Signal signal) { return std::optional(head_injury_criterion(signal, 0.015)); }},
  {"hic36", has::body, [](At, Signal signal) { return std::optional(head_injury_criterion(signal, 0.036)); }},
  {"contact_impulse_Ns", has::impactor, [](At now, Signal) { return std::optional(now.flows.contact_impulse); }},
  {"path_impulse_Ns", has::impactor, [](At now, Signal) { return std::optional(now.flows.path_impulse); }},
  {"first_contact_s", has::impactor, first_contact},
};
// clang-format on

// Those that an ensemble has anyway, and those that the case asks for.
std::vector<int> classes_of(const Scene& scene) {
  std::vector<int> classes;
  std::ranges::set_union(ensemble_channel_classes, scene.output.channel_classes, std::back_inserter(classes));
  return classes;
}

std::vector<std::string> all_names(const Scene& scene) {
  std::vector<std::string> names = quantity_names(scene);
  const auto history = history_columns(scene);
  for (std::size_t c = 1; c < history.size(); ++c) names.push_back(history[c].name);
  return names;
}

// Over the time, the first column.
double integral(const std::vector<std::vector<double>>& rows, std::size_t at) {
  double sum = 0.0;
  for (std::size_t i = 1; i < rows.size(); ++i)
    sum += (rows[i][0] - rows[i - 1][0]) * (rows[i][at] + rows[i - 1][at]) / 2.0;
  return sum;
}

// Name of a value that is not a finite number; empty if there is none.
std::string no_number(const Scene& scene, const RecordedRun& run) {
  const auto is_number = [](const std::optional<double>& value) { return !value || std::isfinite(*value); };
  const auto place = [&](const auto& values) {
    return static_cast<std::size_t>(std::ranges::find_if_not(values, is_number) - values.begin());
  };
  for (const auto& of_row : run.rows)
    if (const std::size_t at = place(of_row); at < of_row.size()) return row_names(scene)[at];
  if (const std::size_t at = place(run.energies); at < run.energies.size())
    return energy_columns(scene)[at].name;
  if (const std::size_t at = place(run.quantities); at < run.quantities.size())
    return quantity_names(scene)[at];
  return {};
}

}  // namespace

std::vector<std::string> quantity_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const Quantity& quantity : kQuantities)
    if (quantity.when(scene)) names.emplace_back(quantity.name);
  return names;
}

std::vector<std::string> row_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const auto& column : history_columns(scene)) names.push_back(column.name);
  if (scene.has_impactor())
    for (const int channel_class : classes_of(scene))
      names.push_back(filtered_column(channel_class, scene.pendulum.has_value()));
  return names;
}

std::vector<std::string> history_quantities(const Scene& scene) {
  std::vector<std::string> names;
  for (const auto& column : history_columns(scene)) names.push_back(column.name);
  const std::size_t columns = names.size();
  for (const char* over_rows : {"max", "min", "integral"})
    for (std::size_t i = 0; i < columns; ++i) names.push_back(fmt::format("{}({})", over_rows, names[i]));
  for (const auto& column : energy_columns(scene))
    if (std::ranges::find(names, column.name) == names.end()) names.push_back(column.name);
  return names;
}

std::string quantity_name(const Scene& scene, const std::string& quantity) {
  const auto names = all_names(scene);
  std::vector<std::string> found;
  for (const auto& name : names) {
    if (name == quantity) return name;
    if (name.starts_with(quantity + '_')) found.push_back(name);
  }
  if (found.size() != 1)
    throw CaseError(fmt::format("--quantity {}: {}, allowed: {}", quantity,
                                found.empty() ? "the scene has none of that name" : "is more than one",
                                fmt::join(found.empty() ? names : found, ", ")));
  return found.front();
}

bool has_quantity(const Scene& scene, const std::string& name) {
  return std::ranges::count(all_names(scene), name) > 0;
}

RecordedRun record_run(const Scene& scene) {
  const double start = cpu_seconds(true);
  State state = make_state(scene);
  RecordedRun run;
  AccelerationRecord acceleration;
  const auto columns = history_columns(scene);
  run.outcome = run_scene(scene, state, [&](bool recorded, const State& now) {
    if (recorded) run.rows.push_back(row(columns, scene, now));
    if (scene.has_impactor()) acceleration.add(recorded, now);
  });
  run.cpu_seconds = cpu_seconds(true) - start;
  for (const int channel_class : scene.has_impactor() ? classes_of(scene) : std::vector<int>{}) {
    const std::vector<double> values = acceleration.at_rows(channel_class);
    for (std::size_t i = 0; i < values.size(); ++i) run.rows[i].push_back(values[i]);
  }
  run.steps = state.steps;
  run.energies = row(energy_columns(scene), scene, state);
  for (const Quantity& quantity : kQuantities)
    if (quantity.when(scene)) run.quantities.push_back(quantity.value(state, acceleration.signal()));
  if (run.outcome.status != RunStatus::done) return run;
  if (const std::string name = no_number(scene, run); !name.empty()) {
    run.outcome.status = RunStatus::failed;
    run.outcome.message = fmt::format("{} is not a finite number", name);
  }
  return run;
}

std::optional<double> quantity_of(const Scene& scene, const RecordedRun& run, const std::string& name) {
  const auto names = quantity_names(scene);
  const auto found = std::ranges::find(names, name);
  if (found != names.end()) return run.quantities[static_cast<std::size_t>(found - names.begin())];
  const auto energies = energy_columns(scene);
  const auto energy = std::ranges::find(energies, name, &Column::name);
  const auto columns = history_columns(scene);
  const auto open = name.find('(');
  const std::string over_rows = open == std::string::npos ? "" : name.substr(0, open);
  const std::string wanted = open == std::string::npos ? name : name.substr(open + 1, name.size() - open - 2);
  const auto column = std::ranges::find(columns, wanted, &Column::name);
  if (column == columns.end() && energy != energies.end())
    return run.energies[static_cast<std::size_t>(energy - energies.begin())];
  if (column == columns.end() || run.rows.empty()) return std::nullopt;
  const auto at = static_cast<std::size_t>(column - columns.begin());
  const auto value = [&](const std::vector<double>& of_row) { return of_row[at]; };
  if (over_rows.empty()) return value(run.rows.back());
  if (over_rows == "max") return value(*std::ranges::max_element(run.rows, {}, value));
  if (over_rows == "min") return value(*std::ranges::min_element(run.rows, {}, value));
  return integral(run.rows, at);
}

}  // namespace driver
