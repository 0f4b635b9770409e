// SPDX-License-Identifier: Apache-2.0
#include "many_runs/run_record.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace driver {
namespace {

using RunJson = nlohmann::json;

bool is_of_shape(const RunRecord& run, const RunShape& shape) {
  constexpr const char* statuses[] = {"done", "inaccurate", "failed", "refused"};
  return run.number >= 0 && run.number < shape.end && (!shape.has || shape.has(run.number)) &&
         run.values.size() == shape.quantities &&
         std::ranges::find(statuses, run.status) != std::end(statuses) &&
         (shape.columns > 0 && run.is_done()) == !run.rows.empty() &&
         std::ranges::all_of(run.rows, [&](const auto& row) { return row.size() == shape.columns; });
}

}  // namespace

std::string line_of(const RunRecord& run) {
  RunJson values = RunJson::array();
  for (const auto& value : run.values) values.push_back(value ? RunJson(*value) : RunJson());
  RunJson json{{"run", run.number},
               {"status", run.status},
               {"steps", run.steps},
               {"cpu_s", run.cpu_seconds},
               {"values", std::move(values)}};
  if (!run.message.empty()) json["message"] = run.message;
  if (!run.warning.empty()) json["warning"] = run.warning;
  if (!run.rows.empty()) json["rows"] = run.rows;
  return json.dump(-1, ' ', false, RunJson::error_handler_t::replace);
}

std::optional<RunRecord> record_of_line(const std::string& line, const RunShape& shape) {
  const RunJson json = RunJson::parse(line, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  RunRecord run;
  try {
    if (!json.at("run").is_number_integer() || !json.at("steps").is_number_integer()) return std::nullopt;
    run.number = json.at("run");
    run.status = json.at("status");
    run.message = json.value("message", "");
    run.warning = json.value("warning", "");
    run.steps = json.at("steps");
    run.cpu_seconds = json.at("cpu_s");
    for (const RunJson& value : json.at("values"))
      run.values.push_back(value.is_null() ? std::nullopt : std::optional(value.get<double>()));
    run.rows = json.value("rows", run.rows);
  } catch (const RunJson::exception&) {
    return std::nullopt;
  }
  return is_of_shape(run, shape) ? std::optional(std::move(run)) : std::nullopt;
}

}  // namespace driver
