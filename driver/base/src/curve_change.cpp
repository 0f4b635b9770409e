// SPDX-License-Identifier: Apache-2.0
#include "curve_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace driver {
namespace {

// What pressures count from. Those of a curve against strain are stresses.
PressureZero zero_of(std::string_view unit, const CurveKind& kind) {
  return unit == "Pa" && kind.abscissa != "strain" ? PressureZero::ambient : PressureZero::none;
}

// The unit that `key` names; SI if there is none.
NamedUnit read_unit(TableReader& table, const std::string& key, const char* si, PressureZero zero,
                    std::optional<double> ambient_pressure) {
  NamedUnit unit;
  if (table.has(key))
    table.located(key, [&] { unit = unit_named(table.at(key).text(), si, zero, ambient_pressure); });
  return unit;
}

}  // namespace

Bounds CurveKind::knots() const {
  return abscissa == "time"           ? any_number.in("s")
         : abscissa == "overpressure" ? any_number.in("Pa")
                                      : any_number;
}

CurveData CurveChange::apply(const CurveData& numbers) const {
  CurveData changed = numbers;
  for (double& t : changed.time) t = knot(t);
  for (double& v : changed.value) v = value(v);
  return changed;
}

CurveChange read_change(TableReader& table, const CurveKind& kind, bool is_constant,
                        std::optional<double> ambient_pressure) {
  CurveChange change;
  const auto has = [&](const char* key) {
    const bool found = table.has(key);
    change.given = change.given || found;
    return found;
  };
  if (kind.integral_unit && !is_constant && has("cumulative"))
    change.cumulative = table.at("cumulative").flag(false);
  const char* unit = change.cumulative ? kind.integral_unit : kind.bounds.unit;
  if (has("scale")) change.scale = table.at("scale").number(any_number, 1.0);
  if (has("offset")) change.offset = table.at("offset").number(any_number.in(unit), 0.0);
  if (kind.is_of_time() && !is_constant) {
    if (has("time_scale")) change.time_scale = table.at("time_scale").number(positive, 1.0);
    if (has("shift")) change.shift = table.at("shift").number(any_number.in("s"), 0.0);
  }
  if (has("units")) {
    TableReader units = table.table("units");
    if (!is_constant)
      change.knot_unit = read_unit(units, kind.abscissa, kind.knots().unit, zero_of(kind.knots().unit, kind),
                                   ambient_pressure);
    change.value_unit = read_unit(units, "value", unit, zero_of(unit, kind), ambient_pressure);
    units.finish();
  }
  return change;
}

CurveData derivative(const CurveData& integral, const std::string& unit, const FailAtKnot& fail) {
  constexpr double rounding = 1e-9;  // share of the largest value; offset may have made the first one 0
  const auto& [time, value] = integral;
  if (!(std::abs(value.front()) <= rounding * std::abs(*std::ranges::max_element(value))))
    fail(0, fmt::format("begins at {} {}, allowed: 0 where the curve is cumulative; offset shifts it",
                        value.front(), unit));
  CurveData slope;
  for (std::size_t i = 1; i < time.size(); ++i) {
    if (value[i] < value[i - 1])
      fail(i, fmt::format("falls from {} to {} {} at knot {}, but a cumulative curve does not", value[i - 1],
                          value[i], unit, i + 1));
    slope.time.insert(slope.time.end(), {time[i - 1], time[i]});
    slope.value.insert(slope.value.end(), 2, (value[i] - value[i - 1]) / (time[i] - time[i - 1]));
  }
  return slope;
}

}  // namespace driver
