// SPDX-License-Identifier: Apache-2.0
// What a curve's table says beside its numbers: units, scale, offset, time_scale, shift and cumulative.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "base/case_reader.hpp"
#include "base/curve_reader.hpp"
#include "base/named_units.hpp"

namespace driver {

/// What a curve is of: the quantities of its knots and of its values.
struct CurveKind {
  Bounds bounds;                        // of the values
  std::string abscissa = "time";        // "time", "overpressure", "strain" or "mass_ratio"
  const char* integral_unit = nullptr;  // of the integral over time, if that may be given instead

  Bounds knots() const;  // any number, with its unit
  bool is_of_time() const { return abscissa == "time"; }
};

/// The curve is value(v) over knot(t) of the numbers (t, v) as given:
///
///     value = scale * v + offset,   time = time_scale * t + shift,
///
/// with v and t in SI units, and with `cumulative` the derivative of that.
struct CurveChange {
  NamedUnit knot_unit, value_unit;
  double scale = 1.0, offset = 0.0, time_scale = 1.0, shift = 0.0;
  bool cumulative = false;
  bool given = false;  // the table has one of these keys

  double value(double v) const { return scale * value_unit.to_si(v) + offset; }
  double knot(double t) const { return time_scale * knot_unit.to_si(t) + shift; }
  CurveData apply(const CurveData& numbers) const;
};

/// Reads the keys of a change from a curve's table; of a constant those that change its value.
CurveChange read_change(TableReader& table, const CurveKind& kind, bool is_constant,
                        std::optional<double> ambient_pressure);

/// Called with the number of a knot and what is wrong there. Does not return.
using FailAtKnot = std::function<void(std::size_t, const std::string&)>;

/// The derivative of a piecewise linear curve: constant between its knots, with a jump at each, so that its
/// integral is the curve again. Calls `fail` unless the curve begins at 0 and does not fall.
CurveData derivative(const CurveData& integral, const std::string& unit, const FailAtKnot& fail);

}  // namespace driver
