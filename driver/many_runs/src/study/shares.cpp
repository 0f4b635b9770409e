// SPDX-License-Identifier: Apache-2.0
// What the shares of a study have computed: a line of JSON for each run.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/journal.hpp"
#include "study/parts.hpp"

namespace driver {
namespace {

using Json = nlohmann::json;

std::optional<double> value_of(const Json& json) {
  return json.is_number() ? std::optional(json.get<double>()) : std::nullopt;
}

// The copy of the plan, and the files that plan and case name.
std::vector<StudyInput> inputs_of(const StudyPlan& plan, const std::filesystem::path& folder) {
  std::vector<StudyInput> inputs{{folder / plan_copy, digits_of_file(folder / plan_copy).value_or("")}};
  for (auto& input : plan.inputs->list()) inputs.push_back(std::move(input));
  return inputs;
}

class ShareReader {
 public:
  ShareReader(const StudyPlan& plan, const std::filesystem::path& folder)
      : plan_(plan), inputs_(inputs_of(plan, folder)) {}

  void read(const std::filesystem::path& file, StudyRecords& records) const {
    std::ifstream stream(file);
    bool known = false;
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
      const std::string place = fmt::format("{}:{}:1", file.string(), ++number);
      if (line.starts_with("{\"build\":") && Json::accept(line)) {
        known = read_head(place, Json::parse(line), records) || known;
      } else if (auto run = run_of_line(plan_, line)) {
        if (!known)
          throw CaseError(
              fmt::format("{}: a run, but no line before it says of which files: an earlier version "
                          "has written it; use another folder",
                          place));
        records.runs.try_emplace(run->number, std::move(*run));
      } else if (Json::accept(line)) {
        throw damaged(place);
      }
    }
    if (stream.bad()) throw CaseError(fmt::format("{}: cannot be read", file.string()));
  }

 private:
  static CaseError damaged(const std::string& place) {
    return CaseError(fmt::format(
        "{}: is damaged: no run of the plan; remove the line, and the same command computes the run again",
        place));
  }

  // False if it names no files.
  bool read_head(const std::string& place, const Json& json, StudyRecords& records) const {
    std::vector<std::pair<std::string, std::string>> inputs;
    try {
      auto lines = json.at("build").get<Provenance>();
      if (records.lines.empty()) records.lines = std::move(lines);
      inputs = json.value("inputs", inputs);
    } catch (const Json::exception&) {
      throw damaged(place);
    }
    if (inputs.empty()) return false;
    if (inputs.size() != inputs_.size())
      throw CaseError(
          fmt::format("{}: its runs have read {} files, not the {} of the plan: another build or "
                      "plan has computed them; use another folder",
                      place, inputs.size(), inputs_.size()));
    for (std::size_t i = 0; i < inputs.size(); ++i)
      if (inputs[i].second != inputs_[i].digits)
        throw CaseError(
            fmt::format("{}: is not as it was when the runs of {} read it (as {}): put it back, or "
                        "use another folder",
                        inputs_[i].file.string(), place, inputs[i].first));
    return true;
  }

  const StudyPlan& plan_;
  std::vector<StudyInput> inputs_;
};

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
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string head_line(const StudyPlan& plan, const std::filesystem::path& folder, const Provenance& build) {
  Json inputs = Json::array();
  for (const auto& [file, digits] : inputs_of(plan, folder)) inputs.push_back({file.string(), digits});
  return Json{{"build", build}, {"inputs", std::move(inputs)}}.dump(-1, ' ', false,
                                                                    Json::error_handler_t::replace) +
         '\n';
}

std::optional<StudyRun> run_of_line(const StudyPlan& plan, const std::string& line) {
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  StudyRun run;
  try {
    if (!json.at("run").is_number_integer() || !json.at("steps").is_number_integer()) return std::nullopt;
    run = {json.at("run"),   json.at("status"), json.value("message", ""), {},
           json.at("steps"), json.at("cpu_s")};
    for (const Json& value : json.at("values")) {
      if (!value.is_null() && !value.is_number()) return std::nullopt;
      run.values.push_back(value_of(value));
    }
  } catch (const Json::exception&) {
    return std::nullopt;
  }
  const bool is_of_plan = run.number >= 0 && run.number < plan.end_of_numbers() &&
                          run.values.size() == plan.quantities.size() &&
                          run.number % plan.most_seeds() < plan.seeds_at(point_of(plan, run.number));
  constexpr const char* statuses[] = {"done", "inaccurate", "failed", "refused"};
  const bool is_status = std::ranges::find(statuses, run.status) != std::end(statuses);
  return is_of_plan && is_status ? std::optional(std::move(run)) : std::nullopt;
}

StudyRecords read_shares(const std::filesystem::path& folder, const StudyPlan& plan, SharesOf build) {
  StudyRecords records;
  const ShareReader reader(plan, folder);
  std::string first_id = build == SharesOf::this_build ? plan.id : "";
  std::filesystem::path first;
  for (const auto& [share, status] : shares_in(folder)) {
    if (!status.files.contains(journal_file)) continue;
    if (first_id.empty()) first_id = status.run, first = share;
    if (status.run != first_id)
      throw CaseError(
          fmt::format("{}: is of another plan, case or build than {}: runs of one are allowed, remove it or "
                      "use another folder",
                      share.string(), first.empty() ? "this study" : first.string()));
    reader.read(share / journal_file, records);
  }
  return records;
}

}  // namespace driver
