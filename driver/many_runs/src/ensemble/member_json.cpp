// SPDX-License-Identifier: Apache-2.0
// A run of many in a journal.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ensemble/member.hpp"

namespace driver {
namespace {

double number_of_json(const nlohmann::json& json) {
  return json.is_null() ? std::nan("") : json.get<double>();
}

}  // namespace

bool has_ended(const Member& member) {
  const RunStatus status = member.outcome.status;
  return status != RunStatus::interrupted && (status != RunStatus::done || !member.rows.empty());
}

std::string line_of(const Member& member) {
  nlohmann::json json{{"status", static_cast<int>(member.outcome.status)},
                      {"message", member.outcome.message},
                      {"warning", member.outcome.warning},
                      {"cpu_s", member.cpu_seconds},
                      {"rows", member.rows},
                      {"quantities", nlohmann::json::array()}};
  for (const auto& value : member.quantities)
    json["quantities"].push_back(value ? nlohmann::json::array({*value}) : nlohmann::json::array());
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

namespace {

Member member_of_entry(const nlohmann::json& json) {
  Member member;
  member.outcome.status = static_cast<RunStatus>(json.at("status").get<int>());
  member.outcome.message = json.at("message");
  member.outcome.warning = json.at("warning");
  member.cpu_seconds = json.at("cpu_s");
  for (const nlohmann::json& row : json.at("rows")) {
    auto& values = member.rows.emplace_back();
    for (const nlohmann::json& value : row) values.push_back(number_of_json(value));
  }
  for (const nlohmann::json& value : json.at("quantities"))
    member.quantities.push_back(value.empty() ? std::nullopt : std::optional(number_of_json(value.front())));
  return member;
}

bool is_of(const Scene& scene, const Member& member) {
  const std::size_t width = row_names(scene).size();
  const auto is_finite = [](const std::optional<double>& value) { return !value || std::isfinite(*value); };
  if (!has_ended(member) || member.quantities.size() != quantity_names(scene).size()) return false;
  if (std::ranges::any_of(member.rows, [&](const auto& row) { return row.size() != width; })) return false;
  if (member.outcome.status != RunStatus::done) return !member.outcome.message.empty();
  return member.rows.back().front() >= scene.time.end * (1.0 - 1e-9) &&  // rounding of the last step
         std::ranges::all_of(member.quantities, is_finite) &&
         std::ranges::all_of(member.rows,
                             [&](const auto& row) { return std::ranges::all_of(row, is_finite); });
}

}  // namespace

std::optional<Member> member_of(const Scene& scene, const nlohmann::json* entry) {
  if (!entry) return std::nullopt;
  try {
    Member member = member_of_entry(*entry);
    return is_of(scene, member) ? std::optional(std::move(member)) : std::nullopt;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

}  // namespace driver
