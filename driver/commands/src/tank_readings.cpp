// SPDX-License-Identifier: Apache-2.0
#include "tank_readings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "base/case_reader.hpp"
#include "base/named_units.hpp"
#include "tank_test/smoothing_spline.hpp"

namespace driver::commands {
namespace {

// The unit that an option names.
NamedUnit unit_of(const char* option, const std::string& name, const char* si, double ambient_pressure) {
  try {
    return unit_named(name, si, PressureZero::vacuum, ambient_pressure);
  } catch (const std::invalid_argument& error) {
    throw CaseError(fmt::format("{} {}", option, error.what()));
  }
}

}  // namespace

CsvTable read_readings(const IdentifyArguments& a) {
  const double ambient = a.ambient_pressure.value_or(standard_atmosphere);
  std::vector<std::string> columns{a.time_column, a.tank_column};
  std::vector<NamedUnit> units{unit_of("--time-unit", a.time_unit, "s", ambient),
                               unit_of("--tank-unit", a.tank_unit, "Pa", ambient)};
  const NamedUnit chamber_unit = unit_of("--chamber-unit", a.chamber_unit, "Pa", ambient);
  if (a.method == "dual") columns.push_back(a.chamber_column), units.push_back(chamber_unit);
  CsvTable table = read_csv(a.file, columns);
  for (std::size_t c = 0; c < columns.size(); ++c)
    for (std::size_t i = 0; i < table.rows(); ++i) {
      table.values[c][i] = units[c].to_si(table.values[c][i]);
      if (!std::isfinite(table.values[c][i])) table.fail(c, i, "is not finite in SI units");
    }
  if (table.rows() < gas::SmoothingSpline::kFewestReadings)
    throw CaseError(fmt::format("{}:{}:1: {}: has {} readings, needed: {} or more", a.file.string(),
                                table.rows() > 0 ? table.lines.back() : 1, a.time_column, table.rows(),
                                gas::SmoothingSpline::kFewestReadings));
  if (table.values[0].front() < 0.0)
    table.fail(0, 0,
               fmt::format("{} s: time counts from firing, allowed: 0 or more", table.values[0].front()));
  return table;
}

std::string units_text(const IdentifyArguments& a) {
  const bool dual = a.method == "dual";
  if (a.time_unit == "s" && a.tank_unit == "Pa" && (!dual || a.chamber_unit == "Pa")) return {};
  return fmt::format("time in {}, tank pressure in {}{}, ambient pressure {} Pa", a.time_unit, a.tank_unit,
                     dual ? ", chamber pressure in " + a.chamber_unit : "",
                     a.ambient_pressure.value_or(standard_atmosphere));
}

}  // namespace driver::commands
