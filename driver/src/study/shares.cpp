// SPDX-License-Identifier: Apache-2.0
// What the shares of a study have computed: a line of JSON for each run.
#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "study/parts.hpp"

namespace driver {
namespace {

using Json = nlohmann::json;

std::optional<double> value_of(const Json& json) {
  return json.is_number() ? std::optional(json.get<double>()) : std::nullopt;
}

Provenance lines_of(const Json& build) {
  Provenance lines;
  for (const auto& line : build)
    lines.emplace_back(line.at(0).get<std::string>(), line.at(1).get<std::string>());
  return lines;
}

void read_share(const std::filesystem::path& file, StudyRecords& records) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("{\"build\":")) {
      const Json json = Json::parse(line, nullptr, false);
      if (json.is_object() && records.lines.empty()) records.lines = lines_of(json.at("build"));
    } else if (auto run = run_of_line(line)) {
      records.runs.try_emplace(run->number, std::move(*run));
    }
  }
}

std::vector<std::filesystem::path> folders_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> list;
  if (std::filesystem::is_directory(folder))
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.is_directory()) list.push_back(entry.path());
  std::ranges::sort(list);
  return list;
}

}  // namespace

std::string line_of(const StudyRun& run) {
  Json values = Json::array();
  for (const auto& value : run.values) values.push_back(value ? Json(*value) : Json());
  Json json{{"run", run.number},
            {"status", run.status},
            {"steps", run.steps},
            {"cpu_s", run.cpu_seconds},
            {"values", std::move(values)}};
  if (!run.message.empty()) json["message"] = run.message;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::optional<StudyRun> run_of_line(const std::string& line) {
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object() || !json.contains("run")) return std::nullopt;
  StudyRun run{json.at("run"),   json.at("status"), json.value("message", ""), {},
               json.at("steps"), json.at("cpu_s")};
  for (const Json& value : json.at("values")) run.values.push_back(value_of(value));
  return run;
}

StudyRecords read_shares(const std::filesystem::path& folder, const std::string& id) {
  StudyRecords records;
  std::string first_id = id;
  std::filesystem::path first;
  for (const auto& share : folders_in(folder / shares_folder)) {
    const auto status = read_status(share);
    if (!status || !status->files.contains(journal_file)) continue;
    if (first_id.empty()) first_id = status->run, first = share;
    if (status->run != first_id)
      throw CaseError(
          fmt::format("{}: is of another plan, case or build than {}: runs of one are allowed, remove it or "
                      "use another folder",
                      share.string(), first.empty() ? "this study" : first.string()));
    read_share(share / journal_file, records);
  }
  return records;
}

}  // namespace driver
