// SPDX-License-Identifier: Apache-2.0
// The files of a ladder.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>
#include <sstream>
#include <thread>

#include "case_settings.hpp"
#include "many_runs/ladder.hpp"
#include "results/results.hpp"
#include "table_text.hpp"

namespace driver {
namespace {

using Json = nlohmann::ordered_json;

bool has_value(const LadderRung& rung) {
  return rung.failure.empty() && rung.value.count > 0;
}

std::string rows_text(const LadderResult& result, const Provenance& lines) {
  std::ostringstream csv;
  csv << comment_lines(lines);
  csv << "rung,runs,value,value_se,error,error_se,cpu_s,cost_ratio,verdict,front,change,change_se,options,"
         "failure\n";
  const bool judged = result.verdict != Verdict::not_judged;
  for (const LadderRung& rung : result.rungs) {
    csv << rung.name << ',' << rung.value.count << ',';
    if (has_value(rung)) {
      const Change change = change_of(result, rung);
      csv << fmt::format("{},{},", rung.value.mean, rung.value.standard_error);
      csv << (judged ? fmt::format("{},{},", rung.error, rung.standard_error) : ",,");
      csv << fmt::format("{:.4g},{:.4g},{},{},{},{},", rung.cpu_seconds,
                         rung.cpu_seconds / result.rungs.front().cpu_seconds, verdict_name(rung.verdict),
                         judged ? fmt::format("{}", rung.front) : "", change.value, change.standard_error);
    } else {
      csv << ",,,,,,not judged,,,,";
    }
    csv << csv_cell(as_options(rung.overrides), true) << ',' << csv_cell(rung.failure, true) << '\n';
  }
  return csv.str();
}

Json reference_json(const LadderReference& reference) {
  Json json{{"value", reference.value},
            {"standard_error", reference.standard_error},
            {"uncertainty", reference.uncertainty}};
  for (const auto& [axis, rest] : reference.remainders)
    json["beyond_finest"][axis] = {{"correction", rest.correction},
                                   {"uncertainty", rest.uncertainty},
                                   {"order", rest.order ? Json(*rest.order) : Json(nullptr)}};
  return json;
}

Json rung_json(const LadderResult& result, const LadderRung& rung) {
  Json json{{"rung", rung.name}, {"differs", rung.differs}, {"options", as_options(rung.overrides)}};
  if (!has_value(rung)) {
    json["failure"] = rung.failure;
    return json;
  }
  json["value"] = rung.value.mean;
  json["value_se"] = rung.value.standard_error;
  json["runs"] = rung.value.count;
  json["cpu_s"] = rung.cpu_seconds;
  if (result.verdict == Verdict::not_judged) return json;
  json["error"] = rung.error;
  json["error_se"] = rung.standard_error;
  json["verdict"] = verdict_name(rung.verdict);
  json["front"] = rung.front;
  return json;
}

// Costs are of a machine; empty where the system does not name it.
std::string machine() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  constexpr std::string_view key = "model name";
  for (std::string line; std::getline(cpuinfo, line);)
    if (const auto colon = line.find(": "); line.starts_with(key) && colon != std::string::npos)
      return fmt::format("{}, {} cores", line.substr(colon + 2), std::thread::hardware_concurrency());
  return {};
}

std::string ladder_json(const LadderResult& result, const LadderOptions& options, const ResultFolder& folder,
                        const char* status) {
  Json json{{"status", status},
            {"run", folder.run()},
            {"quantity", result.quantity},
            {"tolerance", options.tolerance},
            {"verdict", verdict_name(result.verdict)},
            {"reason", result.reason.empty() ? Json(nullptr) : Json(result.reason)},
            {"cheapest", result.cheapest ? Json(result.rungs[*result.cheapest].name) : Json(nullptr)},
            {"counted_from", result.zero},
            {"chaotic", result.chaotic},
            {"spread_of_seeds", result.spread}};
  if (result.verdict != Verdict::not_judged) json["reference"] = reference_json(result.reference);
  if (result.model)
    json["model_band"] = {
        {"low", result.model->low},
        {"lowest", result.model->lowest},
        {"high", result.model->high},
        {"highest", result.model->highest},
        {"cheapest_stands", result.cheapest ? Json(result.model->cheapest_stands) : Json(nullptr)}};
  for (const LadderRung& rung : result.rungs) json["rungs"].push_back(rung_json(result, rung));
  json["held"] = options.hold;
  json["left_out"] = result.plan.left_out;
  Provenance lines = folder.lines();
  if (auto name = machine(); !name.empty()) lines.emplace_back("machine", std::move(name));
  return json_text(std::move(json), lines);
}

std::string cheapest_text(const ResultFolder& folder, const LadderResult& result,
                          const std::filesystem::path& file, const std::vector<std::string>& overrides,
                          const LadderOptions& options) {
  const LadderRung& rung = result.rungs[*result.cheapest];
  const CaseDocument document(file, joined(overrides, rung.overrides));
  const Provenance head{
      {"run", folder.run()},
      {"of", fmt::format("{}: the cheapest rung of its ladder with {} within {:g} % of the reference",
                         file.filename().string(), result.quantity, 100.0 * options.tolerance)},
      {"rung", fmt::format("\"{}\": {}", rung.differs,
                           rung.overrides.empty() ? "the case as it is" : as_options(rung.overrides))},
      {"off by", fmt::format("{:.3g} +- {:.2g} (standard errors and the reference's uncertainty) of {:.6g}",
                             rung.error, rung.doubt, result.reference.value)}};
  return comment_lines(head) + '\n' + document.text(folder.path());
}

}  // namespace

void write_ladder(ResultFolder& folder, const LadderResult& result, const std::filesystem::path& file,
                  const std::vector<std::string>& overrides, const LadderOptions& options, bool partial) {
  Provenance lines = folder.lines();
  if (auto name = machine(); !name.empty()) lines.emplace_back("machine", std::move(name));
  if (partial) lines.emplace_back("status", "interrupted: what had run by then");
  lines.emplace_back("quantity", result.quantity);
  lines.emplace_back("tolerance", fmt::format("{}", options.tolerance));
  if (result.chaotic) lines.emplace_back("error rate", fmt::format("{}", options.error_rate));
  if (result.zero != 0.0) lines.emplace_back("counted from", fmt::format("{}", result.zero));
  if (!options.hold.empty()) lines.emplace_back("held", fmt::format("{}", fmt::join(options.hold, ", ")));
  if (result.verdict != Verdict::not_judged) {
    lines.emplace_back("reference", fmt::format("{}", result.reference.value));
    lines.emplace_back("uncertainty", fmt::format("{}", result.reference.uncertainty));
    if (result.model)
      lines.emplace_back("model band", fmt::format("{} to {}", result.model->low, result.model->high));
  }
  folder.write("ladder.csv", rows_text(result, lines));
  folder.write("ladder.json", ladder_json(result, options, folder, partial ? "interrupted" : "done"));
  if (result.cheapest) folder.write("cheapest.toml", cheapest_text(folder, result, file, overrides, options));
}

}  // namespace driver
