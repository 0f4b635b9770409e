// SPDX-License-Identifier: Apache-2.0
// Curves and compositions of a case file, and curves that stand in a CSV beside it.
#include <fmt/format.h>

#include <cmath>

#include "case/text_file.hpp"
#include "case/toml_library.hpp"
#include "driver/case_reader.hpp"
#include "results/csv_table.hpp"

namespace driver {
namespace {

/// Calls fail(knot, message) for the first fault; `jumps`: two knots at one time are allowed.
void check_knots(const CurveData& curve, bool jumps,
                 const std::function<void(std::size_t, const std::string&)>& fail) {
  const auto& time = curve.time;
  if (curve.time.size() != curve.value.size())
    fail(0, fmt::format("has {} knots and {} values, as many are needed", time.size(), curve.value.size()));
  if (time.size() < 2)
    fail(0, fmt::format("has {} knot{}, 2 or more are needed", time.size(), time.size() == 1 ? "" : "s"));
  for (std::size_t i = 1; i < time.size(); ++i) {
    if (!(time[i] > time[i - 1]) && !(jumps && time[i] == time[i - 1]))
      fail(i, fmt::format("knot {} at {} follows {}: knots in {}rising order are allowed", i + 1, time[i],
                          time[i - 1], jumps ? "" : "strictly "));
    if (i > 1 && time[i] == time[i - 2])
      fail(i, fmt::format("knot {} at {} is the third there: a jump, two knots at one time, is allowed",
                          i + 1, time[i]));
    const double slope = (curve.value[i] - curve.value[i - 1]) / (time[i] - time[i - 1]);
    if (time[i] > time[i - 1] && !std::isfinite(slope))
      fail(i, fmt::format("knots {} and {} are so close that their slope overflows: a jump has two knots at "
                          "one time",
                          i, i + 1));
  }
}

CurveData read_csv_curve(const std::filesystem::path& file, const std::string& knots,
                         const std::string& column, bool jumps) {
  CsvTable table = read_csv(file, {knots, column});
  CurveData curve{std::move(table.values[0]), std::move(table.values[1])};
  check_knots(curve, jumps, [&](std::size_t knot, const std::string& message) {
    const std::size_t line = knot < table.rows() ? table.lines[knot] : 1;
    throw CaseError(fmt::format("{}:{}:1: {}: {}", file.string(), line, column, message));
  });
  return curve;
}

}  // namespace

CurveData TableReader::curve_of_table(const std::string& key, TableReader&& reader, Bounds bounds,
                                      const std::string& abscissa) const {
  CurveData curve;
  const bool jumps = abscissa == "time";
  if (reader.has("file")) {
    const auto file = beside_case(reader.text("file"));
    const auto knots =
        jumps ? reader.text("time_column", "time_s") : reader.text("overpressure_column", "overpressure_Pa");
    const auto column = reader.text("column");
    try {
      curve = read_csv_curve(file, knots, column, jumps);
    } catch (const FileError& error) {
      reader.fail("file", error.what());
    }
    for (const double value : curve.value)
      if (value < bounds.low || value > bounds.high || (bounds.open_low && value == bounds.low))
        fail(key, fmt::format("{} holds {}, {} is allowed", file.string(), value, bounds.text));
  } else {
    curve.time = reader.numbers(abscissa, any_number);
    curve.value = reader.numbers("value", bounds);
    check_knots(curve, jumps, [&](std::size_t, const std::string& message) { fail(key, message); });
  }
  reader.finish();
  return curve;
}

bool TableReader::is_table(const std::string& key) const {
  const toml::node* node = table_->get(key);
  return node && node->is_table();
}

bool TableReader::has_in_table(const std::string& key, const std::string& inner) const {
  return is_table(key) && table_->get(key)->as_table()->contains(inner);
}

CurveData TableReader::curve(const std::string& key, Bounds bounds, const std::string& abscissa) {
  const toml::node& node = require(key, "a number or a curve");
  if (node.is_table()) return curve_of_table(key, table(key), bounds, abscissa);
  return {{}, {number(key, bounds)}};
}

std::map<std::string, double> TableReader::composition(const std::string& key) {
  TableReader reader = table(key);
  std::map<std::string, double> fractions;
  double sum = 0.0;
  for (const auto& [name, node] : *reader.table_)
    sum += fractions[std::string(name.str())] = reader.number(std::string(name.str()), positive_fraction);
  // Fractions are typed by hand: nine digits tell a slip from rounding.
  if (std::abs(sum - 1.0) > 1e-9) fail(key, fmt::format("fractions sum to {}, 1 is allowed", sum));
  return fractions;
}

}  // namespace driver
