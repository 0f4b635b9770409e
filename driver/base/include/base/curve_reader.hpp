// SPDX-License-Identifier: Apache-2.0
// Curves of a case file.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/case_reader.hpp"

namespace driver {

/// A piecewise linear curve: knots [s], and values in the unit of the key. Two knots at one time make a jump.
struct CurveData {
  std::vector<double> time;
  std::vector<double> value;
};

/// Integral of a curve from its first knot to its last, by trapezoids; 0 for a constant.
double integral(const CurveData& curve);

/// A curve as it is used, where the case does not show it.
struct UsedCurve {
  std::string path;
  bool is_changed;       // it has units, a scale or the like; otherwise it is in a file
  std::string abscissa;  // what it is against, such as "time"; empty for a constant
  std::string unit;      // of its values
  CurveData data;        // in SI units
};

struct CurveKind;

/// One key of a table that is a curve. It has one of three forms:
/// - a constant: a number, or { value = number };
/// - { time = [..], value = [..] };
/// - { file = "curve.csv", column = "name" }.
///
/// The tables may have units, scale and offset; a curve of time also time_scale and shift (curve_change.hpp).
/// What is returned has all that applied. A curve against another quantity has its name in place of "time",
/// as in { overpressure = [..], value = [..] }. Only a curve of time may jump.
///
/// Each call reads, checks and records like those of KeyReader.
class CurveReader {
 public:
  CurveReader(TableReader& table, std::string key) : table_(&table), key_(std::move(key)) {}

  /// True if the key exists and is a constant.
  bool is_constant() const;
  /// True if the key exists and is a curve against `abscissa`. A curve in a file is one of time unless it
  /// names another column for its knots.
  bool is_against(const std::string& abscissa) const;

  double constant(Bounds bounds);
  /// The knots are in `time` whatever the curve is against; of a constant there are none. The key may be
  /// missing if there is a `fallback`, a constant.
  CurveData curve(Bounds bounds, const std::string& abscissa = "time", std::optional<double> fallback = {});
  /// A rate against time, 0 or more, which may be given by its integral, in `integral_unit`, with cumulative
  /// = true.
  CurveData curve_or_integral(Bounds bounds, const char* integral_unit);

  /// Sets the ambient pressure [Pa] of the document, for units such as "kPa absolute". Call it before any
  /// curve is read: a curve that is read earlier refuses such units, as in a scene without gas.
  static void set_ambient_pressure(TableReader& root, double pressure);

 private:
  double constant_of(const toml::node& node, Bounds bounds);
  CurveData curve_of(const CurveKind& kind, std::optional<double> fallback);
  KeyReader key() const { return table_->at(key_); }

  TableReader* table_;
  std::string key_;
};

}  // namespace driver
