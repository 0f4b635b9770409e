// SPDX-License-Identifier: Apache-2.0
// The files of a ladder.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "driver/ladder.hpp"
#include "driver/results.hpp"

namespace driver {
namespace {

using Json = nlohmann::ordered_json;

// Its first line tells it from a file of the user's.
constexpr std::string_view cheapest_mark = "# Written by gasjet ladder, which writes it anew each time.";

std::string options_of(const LadderRung& rung) {
  std::string text;
  for (const auto& override_text : rung.overrides) {
    if (!text.empty()) text += ' ';
    text += as_option(override_text);
  }
  return text;
}

// Quoted as RFC 4180 has it.
std::string cell(const std::string& text) {
  std::string quoted(1, '"');
  for (const char c : text) {
    if (c == '"') quoted += c;
    quoted += c == '\n' ? ' ' : c;
  }
  quoted += '"';
  return quoted;
}

bool has_value(const LadderRung& rung) {
  return rung.failure.empty() && rung.value.count > 0;
}

void write_rows(const std::filesystem::path& file, const LadderResult& result, const Provenance& lines) {
  std::ofstream csv(file);
  for (const auto& [key, value] : lines) csv << "# " << key << ": " << value << '\n';
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
    csv << cell(options_of(rung)) << ',' << cell(rung.failure) << '\n';
  }
  csv.flush();
  if (!csv) throw WriteError(fmt::format("{}: write failed", file.string()));
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
  Json json{{"rung", rung.name}, {"differs", rung.differs}, {"options", options_of(rung)}};
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

void write_json(const std::filesystem::path& file, const LadderResult& result, const LadderOptions& options,
                const Provenance& lines) {
  Json json{{"quantity", result.quantity},
            {"tolerance", options.tolerance},
            {"verdict", verdict_name(result.verdict)},
            {"reason", result.reason.empty() ? Json(nullptr) : Json(result.reason)},
            {"cheapest", result.cheapest ? Json(result.rungs[*result.cheapest].name) : Json(nullptr)},
            {"counted_from", result.zero},
            {"chaotic", result.chaotic},
            {"spread_of_seeds", result.spread}};
  if (result.verdict != Verdict::not_judged) json["reference"] = reference_json(result.reference);
  for (const LadderRung& rung : result.rungs) json["rungs"].push_back(rung_json(result, rung));
  json["held"] = options.hold;
  json["left_out"] = result.plan.left_out;
  for (const auto& [key, value] : lines) json["build"][key] = value;
  std::ofstream stream(file);
  stream << json.dump(2) << '\n';
  stream.flush();
  if (!stream) throw WriteError(fmt::format("{}: write failed", file.string()));
}

void write_cheapest(const std::filesystem::path& folder, const LadderResult& result,
                    const std::filesystem::path& file, const std::vector<std::string>& overrides,
                    const LadderOptions& options) {
  const LadderRung& rung = result.rungs[*result.cheapest];
  auto all = overrides;
  all.insert(all.end(), rung.overrides.begin(), rung.overrides.end());
  const CaseDocument document(file, all);
  std::ofstream stream(folder / "cheapest.toml");
  stream << fmt::format(
      "{}\n# {}: the cheapest rung of its ladder with {} within {:g} % of the reference.\n"
      "# Rung \"{}\": {}\n# Off by {:.3g} +- {:.2g} (2 standard errors and the reference's "
      "uncertainty) of "
      "{:.6g}.\n\n",
      cheapest_mark, file.filename().string(), result.quantity, 100.0 * options.tolerance, rung.differs,
      rung.overrides.empty() ? "the case as it is" : options_of(rung), rung.error,
      2.0 * rung.standard_error + result.reference.uncertainty, result.reference.value);
  stream << document.text(folder);
  stream.flush();
  if (!stream) throw WriteError(fmt::format("{}: write failed", (folder / "cheapest.toml").string()));
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

}  // namespace

void refuse_own_cheapest(const std::filesystem::path& folder) {
  std::ifstream file(folder / "cheapest.toml");
  std::string first;
  if (file && !(std::getline(file, first) && first == cheapest_mark))
    throw CaseError(fmt::format(
        "--out {}: would overwrite cheapest.toml, which no ladder wrote; another folder is allowed",
        folder.string()));
}

void write_ladder(const std::filesystem::path& folder, const LadderResult& result,
                  const std::filesystem::path& file, const std::vector<std::string>& overrides,
                  const LadderOptions& options, bool partial) {
  Provenance lines = provenance(file, overrides);
  if (auto name = machine(); !name.empty()) lines.emplace_back("machine", std::move(name));
  if (partial) lines.emplace_back("status", "interrupted: what had run by then");
  lines.emplace_back("quantity", result.quantity);
  lines.emplace_back("tolerance", fmt::format("{}", options.tolerance));
  if (result.zero != 0.0) lines.emplace_back("counted from", fmt::format("{}", result.zero));
  if (!options.hold.empty()) lines.emplace_back("held", fmt::format("{}", fmt::join(options.hold, ", ")));
  if (result.verdict != Verdict::not_judged) {
    lines.emplace_back("reference", fmt::format("{}", result.reference.value));
    lines.emplace_back("uncertainty", fmt::format("{}", result.reference.uncertainty));
  }
  const char* name = partial ? "ladder_partial" : "ladder";
  write_rows(folder / fmt::format("{}.csv", name), result, lines);
  write_json(folder / fmt::format("{}.json", name), result, options, lines);
  if (partial) return;
  for (const char* earlier :
       {"cheapest.toml", "ladder.gp", "ladder.svg", "ladder_partial.csv", "ladder_partial.json"})
    std::filesystem::remove(folder / earlier);
  if (result.cheapest) write_cheapest(folder, result, file, overrides, options);
}

}  // namespace driver
