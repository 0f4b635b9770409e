// SPDX-License-Identifier: Apache-2.0
#include "tank_readings.hpp"

#include <fmt/format.h>

#include <algorithm>
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

std::string chamber_unit(const IdentifyArguments& a) {
  return a.chamber_unit.value_or("Pa");
}

// Units of the columns: time, tank and, for the method "dual", chamber. Refuses options without effect.
std::vector<NamedUnit> units_of(const IdentifyArguments& a) {
  const double ambient = a.ambient_pressure.value_or(standard_atmosphere);
  std::vector<NamedUnit> units{unit_of("--time-unit", a.time_unit, "s", ambient),
                               unit_of("--tank-unit", a.tank_unit, "Pa", ambient)};
  if (a.method == "dual")
    units.push_back(unit_of("--chamber-unit", chamber_unit(a), "Pa", ambient));
  else if (a.chamber_unit)
    throw CaseError("--chamber-unit needs --method dual");
  const auto is_gauge = [](const NamedUnit& unit) { return unit.offset != 0.0; };
  if (a.ambient_pressure && std::ranges::none_of(units, is_gauge))
    throw CaseError("--ambient-pressure needs a gauge unit, such as --tank-unit \"kPa gauge\"");
  return units;
}

}  // namespace

CsvTable read_readings(const IdentifyArguments& a) {
  const std::vector<NamedUnit> units = units_of(a);
  std::vector<std::string> columns{a.time_column, a.tank_column};
  if (a.method == "dual") columns.push_back(a.chamber_column);
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
  if (a.time_unit == "s" && a.tank_unit == "Pa" && (!dual || chamber_unit(a) == "Pa")) return {};
  return fmt::format("time in {}, tank pressure in {}{}, ambient pressure {} Pa", a.time_unit, a.tank_unit,
                     dual ? ", chamber pressure in " + chamber_unit(a) : "",
                     a.ambient_pressure.value_or(standard_atmosphere));
}

}  // namespace driver::commands
