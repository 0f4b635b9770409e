// SPDX-License-Identifier: Apache-2.0
// Units of columns by the endings of their names: the report's page, charts of ladders and scripts/plot.py
// take them from here.
#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace driver {

/// Endings and units. A longer ending comes before a shorter one that it contains.
inline constexpr std::pair<std::string_view, std::string_view> unit_endings[] = {
    {"_m_s2", "m/s²"},   {"_rad_s", "rad/s"}, {"_kg_K_s", "kg K/s"},
    {"_kg_s", "kg/s"},   {"_m_s", "m/s"},     {"_Pa_s", "Pa/s"},
    {"_1_s", "1/s"},     {"_N_s", "N s"},     {"_J_kg_K", "J/(kg K)"},
    {"_kg_m3", "kg/m³"}, {"_J_m3", "J/m³"},   {"_kg_m2", "kg m²"},
    {"_N_m", "N/m"},     {"_m3", "m³"},       {"_m2", "m²"},
    {"_Pa", "Pa"},       {"_kg", "kg"},       {"_Nm", "N m"},
    {"_Ns", "N s"},      {"_rad", "rad"},     {"_deg", "°"},
    {"_Hz", "Hz"},       {"_sr", "sr"},       {"_K", "K"},
    {"_W", "W"},         {"_N", "N"},         {"_J", "J"},
    {"_m", "m"},         {"_s", "s"},
};

/// The name without the ending of its unit.
inline std::string without_unit(std::string_view name) {
  for (const auto& [ending, unit] : unit_endings)
    if (name.ends_with(ending)) return std::string(name.substr(0, name.size() - ending.size()));
  return std::string(name);
}

/// The unit that a name ends in; empty if it ends in none.
inline std::string_view unit_by_ending(std::string_view name) {
  for (const auto& [ending, unit] : unit_endings)
    if (name.ends_with(ending)) return unit;
  return {};
}

}  // namespace driver
