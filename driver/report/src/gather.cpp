// SPDX-License-Identifier: Apache-2.0
// From the files of a result to the data of the page.
#include "gather.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/csv_table.hpp"
#include "base/number_text.hpp"
#include "base/result_folder.hpp"
#include "base/text_file.hpp"
#include "compare/compare.hpp"
#include "engine/channel_filter.hpp"
#include "engine/energy_terms.hpp"
#include "page_frames.hpp"
#include "table.hpp"

namespace driver {
namespace {

using Json = nlohmann::ordered_json;

bool has_file(const std::filesystem::path& folder, const char* name) {
  std::error_code ignored;
  return std::filesystem::exists(folder / name, ignored);
}

Json read_json(const std::filesystem::path& file) {
  Json json = Json::parse(read_text(file), nullptr, false);
  if (!json.is_object()) throw CaseError(file.string() + ": is not a JSON object, or is incomplete");
  if (json.contains("run")) require_whole(file, json["run"].get<std::string>());
  return json;
}

// Adds a table to `result`, and a note if it was thinned.
PageTable add_table(Json& result, const char* key, const std::filesystem::path& file,
                    const ReportOptions& options) {
  require_whole(file);
  PageTable table = read_page_table(file, options.most_rows);
  result[key] = {{"columns", table.columns}, {"rows", std::move(table.rows)}};
  if (table.kept < table.total)
    result["notes"].push_back(fmt::format("{} is thinned to {} of {} rows; each column's extremes are kept",
                                          file.filename().string(), table.kept, table.total));
  return table;
}

Json start(const std::filesystem::path& result, const char* kind) {
  auto name = result.lexically_normal();
  if (!name.has_filename()) name = name.parent_path();
  return {{"label", name.filename() == "." ? "result" : name.filename().string()},
          {"kind", kind},
          {"notes", Json::array()}};
}

const char* role_name(Role role) {
  return is_held(role)            ? "held"
         : role == Role::spent    ? "spent"
         : role == Role::supplied ? "supplied"
                                  : "none";
}

Json roles() {
  Json names = Json::object();
  for (const EnergyTerm& term : energy_terms()) names[term.name] = role_name(term.role);
  return names;
}

void add_comparison(Json& run, const std::filesystem::path& history, const ReportOptions& options) {
  const PageTable reference = add_table(run, "reference", options.reference, options);
  if (!reference.intervals.empty())
    throw CaseError(fmt::format("--against {}: {}: a reference states its band as half width, in NAME{}",
                                options.reference.string(), reference.columns[reference.intervals[0].first],
                                band_suffix));
  const Difference difference = compare(read_history(history), read_history(options.reference));
  Json& comparison = run["compare"] = {{"reference", options.reference.filename().string()},
                                       {"verdict", verdict_name(difference.verdict)},
                                       {"reason", difference.reason},
                                       {"quantities", Json::object()}};
  for (const QuantityDifference& q : difference.quantities) {
    Json& one =
        comparison["quantities"][q.name] = {{"verdict", verdict_name(q.verdict)}, {"reason", q.reason}};
    if (q.values.empty()) continue;
    one["max_error"] = q.largest.value;
    if (!q.band.empty()) one["share_of_band"] = q.share_of_band;
  }
}

// Adds the rows as filtered in a laboratory, if their sampling rate is at least ten times the class, as SAE
// J211 requires.
void add_filtered(Json& run, const std::filesystem::path& file, const PageTable& table) {
  const std::vector<std::string> names{"time_s", "pendulum_cg_tangential_m_s2", "pendulum_cg_radial_m_s2"};
  for (const auto& name : names)
    if (std::ranges::find(table.columns, name) == table.columns.end()) return;
  if (table.kept < table.total) return;
  CsvTable rows = read_csv(file, names);
  VectorSignal signal{std::move(rows.values[0]), std::move(rows.values[1]), std::move(rows.values[2]), {}};
  double widest = 0.0;
  for (std::size_t i = 1; i < signal.time.size(); ++i)
    widest = std::max(widest, signal.time[i] - signal.time[i - 1]);
  if (signal.time.size() < 2 || widest > widest_interval(impactor_channel_class)) return;
  const std::vector<double> resultant = filtered_resultant(signal, impactor_channel_class);
  std::string text;
  for (std::size_t i = 0; i < resultant.size(); ++i)
    text += fmt::format("{}{},{:.6g}", i > 0 ? "\n" : "", signal.time[i], resultant[i]);
  run["filtered"] = {{"columns", {"time_s", "pendulum_cg_acceleration,_CFC_180_m_s2"}}, {"rows", text}};
}

// The id of the run that wrote a table; empty if the table has none.
std::string run_line(const PageTable& table) {
  for (const auto& [name, text] : table.lines)
    if (name == "run") return text;
  return {};
}

// Throws CaseError unless two files are of one run; for folders without a status.
void require_same_run(const std::filesystem::path& file, const std::string& own, const PageTable& main) {
  if (const auto other = run_line(main); !own.empty() && !other.empty() && own != other)
    throw CaseError(fmt::format("{}: is of the run '{}', but the table beside it of '{}': run the case again",
                                file.string(), own, other));
}

// Throws CaseError unless two tables of one run end at the same time.
void require_same_run(const std::filesystem::path& file, const PageTable& table, const PageTable& main) {
  require_same_run(file, run_line(table), main);
  if (table.end != main.end)
    throw CaseError(
        fmt::format("{}: ends at {} s, but the table beside it at {} s: one of them is incomplete",
                    file.string(), digits_beside(table.end, main.end), digits_beside(main.end, table.end)));
}

std::string run_in(const Json& json) {
  return json.is_object() ? json.value("run", std::string()) : std::string();
}

void require_end(double end, const char* who, const std::filesystem::path& file, double last) {
  if (last < end * (1.0 - 1e-6))
    throw CaseError(fmt::format("{}: ends at {} s, but the run at {} s (see {}): the file is incomplete",
                                file.string(), digits_beside(last, end), digits_beside(end, last), who));
}

// Throws CaseError unless a file of a finished run ends with the run.
void require_end(const Json& run, const std::filesystem::path& file, double last) {
  if (!run.contains("summary")) return;
  const Json& summary = run["summary"];
  if (summary.at("status") == "done" && summary.contains("time_end_s"))
    require_end(summary["time_end_s"], "summary.json", file, last);
}

// The page shows the files that exist; only the history is required.
Json gather_run(const std::filesystem::path& folder, const ReportOptions& options) {
  Json run = start(folder, "run");
  const PageTable history = add_table(run, "history", folder / "history.csv", options);
  add_filtered(run, folder / "history.csv", history);
  const auto missing = [&](const char* name, const char* what) {
    run["notes"].push_back(fmt::format("{} is missing: {}", name, what));
  };
  if (has_file(folder, "energy.csv")) {
    const auto file = folder / "energy.csv";
    require_same_run(file, add_table(run, "energy", file, options), history);
    run["roles"] = roles();
  } else {
    missing("energy.csv", "no balance of energy");
  }
  if (has_file(folder, "summary.json")) {
    run["summary"] = read_json(folder / "summary.json");
    for (const char* key : {"scene", "status"}) run["summary"].at(key).get<std::string>();
    run["build"] = run["summary"].value("build", Json());
    require_same_run(folder / "summary.json", run_in(run["summary"]), history);
    require_end(run, folder / "history.csv", history.end);
  } else {
    missing("summary.json", "no summary");
  }
  if (has_file(folder, "check.json")) {
    run["check"] = read_json(folder / "check.json");
    require_same_run(folder / "check.json", run_in(run["check"]), history);
    for (const char* key : {"forecast", "defaults", "warnings"})
      run["check"].at(key).get<std::vector<Json>>();
  } else {
    missing("check.json", "no settings and no forecast");
  }
  run["frames"] = read_frames(folder / "frames.bin", options.most_frame_bytes);
  if (!run["frames"].is_null()) {
    require_same_run(folder / "frames.bin", run_in(run["frames"]["header"]), history);
    require_end(run, folder / "frames.bin", run["frames"]["end_s"]);
  }
  if (const Json& frames = run["frames"]; !frames.is_null() && frames["count"] < frames["total"])
    run["notes"].push_back(fmt::format("{} of {} frames are shown", frames["count"].get<std::size_t>(),
                                       frames["total"].get<std::size_t>()));
  const auto has = [&](const char* column) { return std::ranges::count(history.columns, column) > 0; };
  if (run["frames"].is_null() && (has("skin_area_m2") || has("jet_force_N")))
    missing("frames.bin", "no pictures in three dimensions (output.frames)");
  if (!options.reference.empty()) add_comparison(run, folder / "history.csv", options);
  return run;
}

Json gather_ensemble(const std::filesystem::path& folder, const ReportOptions& options) {
  Json ensemble = start(folder, "ensemble");
  const PageTable table = add_table(ensemble, "history", folder / "ensemble.csv", options);
  for (const auto& [key, value] : table.lines) ensemble["build"][key] = value;
  if (has_file(folder, "runs.csv")) {
    const auto file = folder / "runs.csv";
    require_same_run(file, add_table(ensemble, "singles", file, options), table);
  }
  const Json all = read_json(folder / "ensemble.json");
  if (!all.value("run", Json()).is_string() || !all.value("runs_ended", Json()).is_number() ||
      !all.contains("time_end_s"))
    throw CaseError((folder / "ensemble.json").string() + ": is not a result of gasjet ensemble");
  require_same_run(folder / "ensemble.json", run_in(all), table);
  if (const Json& end = all["time_end_s"]; !end.is_null())
    require_end(end, "ensemble.json", folder / "ensemble.csv", table.end);
  ensemble["quantities"] = all.value("quantities", Json::object());
  int runs = 0;
  for (const Json& quantity : ensemble["quantities"]) runs = std::max(runs, quantity.value("runs", 0));
  ensemble["runs"] = runs;
  for (const Json& failure : all.value("failures", Json::array())) ensemble["notes"].push_back(failure);
  if (!options.reference.empty()) add_comparison(ensemble, folder / "ensemble.csv", options);
  return ensemble;
}

Json gather_ladder(const std::filesystem::path& folder) {
  Json ladder = start(folder, "ladder");
  ladder["ladder"] = read_json(folder / "ladder.json");
  if (const Json& own = ladder["ladder"];
      !own.value("rungs", Json()).is_array() || !own.value("quantity", Json()).is_string())
    throw CaseError((folder / "ladder.json").string() + ": is not a result of gasjet ladder");
  ladder["build"] = ladder["ladder"].value("build", Json());
  return ladder;
}

Json gather_curves(const std::filesystem::path& file, const ReportOptions& options) {
  Json curves = start(file, "curves");
  const PageTable table = add_table(curves, "history", file, options);
  for (const auto& [key, value] : table.lines) curves["build"][key] = value;
  if (!curves["build"].contains("version") || !curves["build"].contains("commit")) curves.erase("build");
  if (!options.reference.empty()) add_comparison(curves, file, options);
  return curves;
}

std::vector<std::filesystem::path> ensembles_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> list;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.is_directory() && has_file(entry.path(), "ensemble.csv")) list.push_back(entry.path());
  std::ranges::sort(list);
  return list;
}

}  // namespace

std::vector<Json> gather(const std::filesystem::path& result, const ReportOptions& options) {
  std::error_code ignored;
  const bool is_run = has_file(result, "history.csv");
  if (!options.reference.empty() && !is_run && has_file(result, "ladder.json"))
    throw CaseError(fmt::format("--against: {} is a ladder, allowed: a run, an ensemble or a history (CSV)",
                                result.string()));
  if (std::filesystem::is_regular_file(result, ignored)) {
    if (result.extension() != ".csv" && read_status(result.parent_path()))
      throw CaseError(
          fmt::format("{}: is a part of a result, allowed: its folder or a CSV file", result.string()));
    return {gather_curves(result, options)};
  }
  if (!std::filesystem::is_directory(result, ignored))
    throw CaseError(fmt::format("{}: no such folder or file", result.string()));
  if (is_run) return {gather_run(result, options)};
  if (has_file(result, "ensemble.csv")) return {gather_ensemble(result, options)};
  if (has_file(result, "ladder.json")) return {gather_ladder(result)};
  std::vector<Json> list;
  for (const auto& folder : ensembles_in(result)) list.push_back(gather_ensemble(folder, options));
  if (const auto status = read_status(result); list.empty() && status && status->status != "done")
    throw CaseError(
        fmt::format("{}: has no results yet, its {} is {} (see {}): run the same command to continue",
                    result.string(), status->command, status->status, status_file));
  if (list.empty())
    throw CaseError(fmt::format("{}: is not a result: it has no history.csv, ensemble.csv or ladder.json",
                                result.string()));
  return list;
}

}  // namespace driver
