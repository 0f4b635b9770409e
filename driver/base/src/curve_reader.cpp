// SPDX-License-Identifier: Apache-2.0
#include "base/curve_reader.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/csv_table.hpp"
#include "base/text_file.hpp"
#include "case_log.hpp"
#include "curve_change.hpp"
#include "toml_library.hpp"

namespace driver {
namespace {

// Fails at the first fault; `jumps`: two knots at one time are allowed.
void check_knots(const CurveData& curve, bool jumps, const FailAtKnot& fail) {
  const auto& time = curve.time;
  if (curve.time.size() != curve.value.size())
    fail(0, fmt::format("has {} knots and {} values, equal numbers are needed", time.size(),
                        curve.value.size()));
  if (time.size() < 2)
    fail(0, fmt::format("has {} knot{}, needed: 2 or more", time.size(), time.size() == 1 ? "" : "s"));
  for (std::size_t i = 1; i < time.size(); ++i) {
    if (!(time[i] > time[i - 1]) && !(jumps && time[i] == time[i - 1]))
      fail(i, fmt::format("knot {} at {} follows {}, allowed: knots in {}rising order", i + 1, time[i],
                          time[i - 1], jumps ? "" : "strictly "));
    if (i > 1 && time[i] == time[i - 2])
      fail(i, fmt::format("knot {} at {} is the third there, allowed: a jump, two knots at one time", i + 1,
                          time[i]));
    const double slope = (curve.value[i] - curve.value[i - 1]) / (time[i] - time[i - 1]);
    if (time[i] > time[i - 1] && !std::isfinite(slope))
      fail(
          i,
          fmt::format(
              "knots {} and {} are so close that their slope overflows: for a jump use two knots at one time",
              i, i + 1));
  }
}

// A curve's numbers as given, and where they stand.
struct CurveSource {
  CurveData numbers;
  std::function<void(const std::string&)> fail_at_key;
  std::optional<CsvTable> table = {};  // of a file: knots and values

  // Throws CaseError for a fault of a knot: in the file at its line.
  void fail(std::size_t knot, const std::string& message) const {
    if (!table) fail_at_key(message);
    const std::size_t line = knot < table->rows() ? table->lines[knot] : 1;
    throw CaseError(fmt::format("{}:{}:1: {}: {}", table->file.string(), line, table->names[1], message));
  }
  FailAtKnot failing() const {
    return [this](std::size_t knot, const std::string& message) { fail(knot, message); };
  }
};

// Knots of a curve, or the column of a file that has them, by what the curve is against.
std::vector<double> knots(TableReader& reader, const CurveKind& kind, bool changed) {
  const Bounds bounds = changed ? any_number : kind.knots();
  if (kind.abscissa == "time") return reader.at("time").numbers(bounds);
  if (kind.abscissa == "overpressure") return reader.at("overpressure").numbers(bounds);
  return kind.abscissa == "strain" ? reader.at("strain").numbers(bounds)
                                   : reader.at("mass_ratio").numbers(bounds);
}

std::string knots_column(TableReader& reader, const CurveKind& kind) {
  if (kind.abscissa == "time") return reader.at("time_column").text("time_s");
  if (kind.abscissa == "overpressure") return reader.at("overpressure_column").text("overpressure_Pa");
  return kind.abscissa == "strain" ? reader.at("strain_column").text("strain")
                                   : reader.at("mass_ratio_column").text("mass_ratio");
}

void read_file(TableReader& reader, const CurveKind& kind, CurveSource& source) {
  const auto file = reader.beside_case(reader.at("file").text());
  const auto times = knots_column(reader, kind);
  const auto column = reader.at("column").text();
  try {
    source.table = read_csv(file, {times, column});
  } catch (const FileError& error) {
    reader.fail("file", error.what());
  }
  source.numbers = {source.table->values[0], source.table->values[1]};
}

// The curve in SI units. Knots are checked as given, where messages have the numbers of the file, and again
// after the change, which may have rounded two into one.
CurveData change_curve(const CurveSource& source, const CurveChange& change, const CurveKind& kind) {
  check_knots(source.numbers, kind.is_of_time() && !change.cumulative, source.failing());
  if (!change.given) return source.numbers;
  CurveData curve = change.apply(source.numbers);
  for (std::size_t i = 0; i < curve.value.size(); ++i)
    if (!std::isfinite(curve.time[i]) || !std::isfinite(curve.value[i]))
      source.fail(i, fmt::format("knot {} is not finite after units, scale and offset", i + 1));
  check_knots(curve, kind.is_of_time() && !change.cumulative, source.failing());
  return change.cumulative ? derivative(curve, kind.integral_unit, source.failing()) : curve;
}

std::string outside(double value, const CurveChange& change, const Bounds& bounds) {
  return fmt::format("{}{}, allowed: {}", value, change.given ? " after units, scale and offset" : "",
                     with_unit(bounds.text, bounds.unit));
}

CurveData curve_of_table(TableReader& reader, const CurveKind& kind, const CurveChange& change,
                         const std::function<void(const std::string&)>& fail) {
  CurveSource source{{}, fail};
  if (reader.has("file")) {
    read_file(reader, kind, source);
  } else {
    // After a change other numbers may be in range.
    source.numbers.time = knots(reader, kind, change.given);
    source.numbers.value = reader.at("value").numbers(change.given ? any_number : kind.bounds);
  }
  reader.finish();
  CurveData curve = change_curve(source, change, kind);
  for (std::size_t i = 0; i < curve.value.size(); ++i)
    if (!kind.bounds.contain(curve.value[i]))
      source.fail(i, "has " + outside(curve.value[i], change, kind.bounds));
  return curve;
}

}  // namespace

double integral(const CurveData& curve) {
  double sum = 0.0;
  for (std::size_t i = 1; i < curve.time.size(); ++i)
    sum += (curve.time[i] - curve.time[i - 1]) * (0.5 * curve.value[i] + 0.5 * curve.value[i - 1]);
  return sum;
}

bool CurveReader::is_constant() const {
  const toml::node* node = table_->table_->get(key_);
  const toml::node* value = node && node->is_table() ? node->as_table()->get("value") : node;
  return value && value->is_number();
}

bool CurveReader::is_against(const std::string& abscissa) const {
  if (!table_->is_table(key_) || is_constant()) return false;
  if (abscissa != "time")
    return table_->has_in_table(key_, abscissa) || table_->has_in_table(key_, abscissa + "_column");
  return table_->has_in_table(key_, "time") ||
         (table_->has_in_table(key_, "file") && !is_against("overpressure"));
}

void CurveReader::set_ambient_pressure(TableReader& root, double pressure) {
  root.log_->ambient_pressure = pressure;
}

double CurveReader::constant(Bounds bounds) {
  return constant_of(table_->require(key_, bounds.unit, bounds.text), bounds);
}

double CurveReader::constant_of(const toml::node& node, Bounds bounds) {
  if (!node.is_table()) {
    const double value = key().checked(node, bounds);
    key().remember(fmt::format("{}", value), false);
    return value;
  }
  TableReader reader = table_->below(key_, node);
  const CurveChange change = read_change(reader, {bounds}, true, table_->log_->ambient_pressure);
  const double value = change.value(reader.at("value").number(change.given ? any_number : bounds));
  reader.finish();
  if (!bounds.contain(value)) table_->fail(key_, "is " + outside(value, change, bounds));
  if (change.given)
    table_->log_->curves.push_back({table_->join(key_), true, "", bounds.unit, {{}, {value}}});
  return value;
}

CurveData CurveReader::curve_of(const CurveKind& kind, std::optional<double> fallback) {
  const std::string allowed = fmt::format("a curve of {}: {}", kind.abscissa, kind.bounds.text);
  const toml::node* node =
      fallback ? table_->find(key_, kind.bounds.unit, fmt::format("{}; or {}", kind.bounds.text, allowed),
                              fmt::format("{}", *fallback))
               : &table_->require(key_, kind.bounds.unit, allowed, "a number or a curve");
  if (node && node->is_table() && !is_constant()) {
    TableReader reader = table_->below(key_, *node);
    const CurveChange change = read_change(reader, kind, false, table_->log_->ambient_pressure);
    const bool from_file = reader.has("file");
    CurveData curve = curve_of_table(reader, kind, change,
                                     [&](const std::string& message) { table_->fail(key_, message); });
    if (change.given || from_file)
      table_->log_->curves.push_back(
          {table_->join(key_), change.given, kind.abscissa, kind.bounds.unit, curve});
    return curve;
  }
  if (!fallback) return {{}, {constant(kind.bounds)}};
  if (node) return {{}, {constant_of(*node, kind.bounds)}};
  key().remember(fmt::format("{}", *fallback), true);
  return {{}, {*fallback}};
}

CurveData CurveReader::curve(Bounds bounds, const std::string& abscissa, std::optional<double> fallback) {
  return curve_of({bounds, abscissa}, fallback);
}

CurveData CurveReader::curve_or_integral(Bounds bounds, const char* integral_unit) {
  return curve_of({bounds, "time", integral_unit}, {});
}

}  // namespace driver
