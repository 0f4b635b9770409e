// SPDX-License-Identifier: Apache-2.0
#include "column_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <unordered_set>

#include "base/case_reader.hpp"

namespace driver {
namespace {

bool is_band(const std::string& name) {
  return name.size() > std::string(band_suffix).size() && name.ends_with(band_suffix);
}

// True for a column that belongs to another one, such as its band.
bool is_companion(const std::string& name, const History& history) {
  return is_band(name) ||
         (history.runs > 1 && (name.ends_with(standard_error_suffix) || name.ends_with(scatter_suffix)));
}

void check_name(const char* option, const std::string& name, const std::vector<std::string>& names) {
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw CaseError(fmt::format("{} {}: {}, allowed: {}", option, name.empty() ? "''" : name,
                                name.empty() ? "a name is empty" : "the reference has no such quantity",
                                fmt::join(names, ", ")));
}

}  // namespace

std::vector<std::string> names_to_compare(const History& reference, const std::vector<std::string>& only,
                                          const Tolerance& tolerance) {
  std::vector<std::string> names;
  for (const auto& [name, values] : reference.columns)
    if (!is_companion(name, reference)) names.push_back(name);
  for (const auto& name : only) {
    if (std::count(only.begin(), only.end(), name) > 1)
      throw CaseError(fmt::format("--columns {}: is given twice, allowed: once", name));
    check_name("--columns", name, names);
  }
  for (const auto& [name, share] : tolerance.of) check_name("--tolerance", name, names);
  return only.empty() ? names : only;
}

bool states_band(const History& reference) {
  return std::ranges::any_of(reference.columns, [](const auto& column) { return is_band(column.first); });
}

void check_bands(const History& reference) {
  std::unordered_set<std::string_view> names;
  for (const auto& [name, values] : reference.columns) names.insert(name);
  for (const auto& [name, values] : reference.columns) {
    if (!is_band(name)) continue;
    const std::string quantity = name.substr(0, name.size() - std::string(band_suffix).size());
    if (!names.contains(quantity))
      throw CaseError(fmt::format("{}: the reference has a band but no column {}", name, quantity));
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i] < 0.0)
        throw CaseError(fmt::format("{}: {} at {:.6g} s: is not a half width of 0 or more", name, values[i],
                                    reference.time[i]));
  }
}

PressureZero zero_of(const std::string& name) {
  if (name.find("overpressure") != name.npos) return PressureZero::ambient;
  return name.find("stress") != name.npos ? PressureZero::none : PressureZero::vacuum;
}

}  // namespace driver
