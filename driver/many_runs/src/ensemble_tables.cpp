// SPDX-License-Identifier: Apache-2.0
// The files of an ensemble.
#include <fmt/format.h>

#include "many_runs/ensemble.hpp"
#include "table_text.hpp"

namespace driver {
namespace {

std::string rows_text(const EnsembleResult& result) {
  std::string csv = "time_s";
  for (const auto& name : result.columns) csv += fmt::format(",{0}_mean,{0}_standard_error", name);
  csv += '\n';
  for (const EnsembleRow& row : result.rows) {
    csv += fmt::format("{}", row.time_s);
    for (const auto& s : row.values) csv += fmt::format(",{},{}", s.mean, s.standard_error);
    csv += '\n';
  }
  return csv;
}

std::string singles_text(const EnsembleResult& result) {
  std::string csv = "time_s";
  for (const auto& single : result.singles)
    for (const auto& name : result.columns) csv += fmt::format(",{}_run_{}", name, single.seed);
  csv += '\n';
  for (std::size_t i = 0; !result.singles.empty() && i < result.singles.front().rows.size(); ++i) {
    csv += fmt::format("{}", result.rows[i * result.singles_every].time_s);
    for (const auto& single : result.singles)
      for (const double value : single.rows[i]) csv += fmt::format(",{:.6g}", value);
    csv += '\n';
  }
  return csv;
}

std::string quantities_text(const EnsembleResult& result) {
  std::string table = "quantity,mean,standard_error,minimum,maximum,runs\n";
  for (const auto& [name, values] : result.quantities) {
    const Statistics s = statistics(values);
    table +=
        fmt::format("{},{},{},{},{},{}\n", name, s.mean, s.standard_error, s.minimum, s.maximum, s.count);
  }
  return table;
}

std::string ensemble_json(const ResultFolder& folder, const EnsembleResult& result) {
  nlohmann::ordered_json json{{"status", status_of(result)},
                              {"run", folder.run()},
                              {"runs_asked", result.asked},
                              {"runs_ended", result.ended},
                              {"time_end_s", nullptr}};
  if (!result.rows.empty()) json["time_end_s"] = result.rows.back().time_s;
  for (const auto& [name, values] : result.quantities) {
    const Statistics s = statistics(values);
    json["quantities"][name] = {{"mean", s.mean},       {"standard_error", s.standard_error},
                                {"minimum", s.minimum}, {"maximum", s.maximum},
                                {"runs", s.count},      {"values", values}};
  }
  json["failures"] = result.failures;
  if (!result.warnings.empty()) json["warnings"] = result.warnings;
  return json_text(std::move(json), folder.lines());
}

}  // namespace

const char* status_of(const EnsembleResult& result) {
  return result.ended == result.asked ? "done" : "interrupted";
}

void write_ensemble(ResultFolder& folder, const EnsembleResult& result) {
  Provenance lines = folder.lines();
  lines.emplace_back("status",
                     fmt::format("{}, {} of {} runs", status_of(result), result.ended, result.asked));
  // What `compare` needs: runs that are in the means of the history.
  const int in_means = result.rows.empty() ? 0 : result.rows.front().values.front().count;
  lines.emplace_back("runs", fmt::format("{}", in_means));
  const std::string head = comment_lines(lines);
  folder.write("ensemble.csv", head + rows_text(result));
  folder.write("quantities.csv", head + quantities_text(result));
  folder.write("runs.csv", head + singles_text(result));
  folder.write("ensemble.json", ensemble_json(folder, result));
}

}  // namespace driver
