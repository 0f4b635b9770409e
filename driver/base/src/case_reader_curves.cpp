// SPDX-License-Identifier: Apache-2.0
// Curves and compositions of a case file, and curves in a CSV file.
#include <fmt/format.h>

#include <cmath>

#include "base/case_reader.hpp"
#include "base/csv_table.hpp"
#include "base/text_file.hpp"
#include "case_log.hpp"
#include "toml_library.hpp"

namespace driver {
namespace {

/// Calls fail(knot, message) for the first fault; `jumps`: two knots at one time are allowed.
void check_knots(const CurveData& curve, bool jumps,
                 const std::function<void(std::size_t, const std::string&)>& fail) {
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

// Knots of a curve, or the column of a file that has them, by what the curve is against.
std::vector<double> knots(TableReader& reader, const std::string& abscissa) {
  if (abscissa == "time") return reader.at("time").numbers(any_number.in("s"));
  if (abscissa == "overpressure") return reader.at("overpressure").numbers(any_number.in("Pa"));
  return abscissa == "strain" ? reader.at("strain").numbers(any_number)
                              : reader.at("mass_ratio").numbers(any_number);
}

std::string knots_column(TableReader& reader, const std::string& abscissa) {
  if (abscissa == "time") return reader.at("time_column").text("time_s");
  if (abscissa == "overpressure") return reader.at("overpressure_column").text("overpressure_Pa");
  return abscissa == "strain" ? reader.at("strain_column").text("strain")
                              : reader.at("mass_ratio_column").text("mass_ratio");
}

CurveData curve_of_table(TableReader&& reader, Bounds bounds, const std::string& abscissa,
                         const std::function<void(const std::string&)>& fail) {
  CurveData curve;
  const bool jumps = abscissa == "time";
  if (reader.has("file")) {
    const auto file = reader.beside_case(reader.at("file").text());
    const auto abscissae = knots_column(reader, abscissa);
    const auto column = reader.at("column").text();
    try {
      curve = read_csv_curve(file, abscissae, column, jumps);
    } catch (const FileError& error) {
      reader.fail("file", error.what());
    }
    for (const double value : curve.value)
      if (value < bounds.low || value > bounds.high || (bounds.open_low && value == bounds.low))
        fail(
            fmt::format("{} has {}, allowed: {}", file.string(), value, with_unit(bounds.text, bounds.unit)));
  } else {
    curve.time = knots(reader, abscissa);
    curve.value = reader.at("value").numbers(bounds);
    check_knots(curve, jumps, [&](std::size_t, const std::string& message) { fail(message); });
  }
  reader.finish();
  return curve;
}

}  // namespace

CurveData KeyReader::curve(Bounds bounds, const std::string& abscissa, std::optional<double> fallback) {
  const std::string allowed = fmt::format("a curve of {}: {}", abscissa, bounds.text);
  const toml::node* node =
      fallback ? table_->find(key_, bounds.unit, fmt::format("{}; or {}", bounds.text, allowed),
                              fmt::format("{}", *fallback))
               : &table_->require(key_, bounds.unit, allowed, "a number or a curve");
  if (node && node->is_table())
    return curve_of_table(table_->below(key_, *node), bounds, abscissa,
                          [&](const std::string& message) { fail(message); });
  if (!fallback) return {{}, {number(bounds)}};
  const double value = node ? checked(*node, bounds) : *fallback;
  remember(fmt::format("{}", value), !node);
  return {{}, {value}};
}

std::map<std::string, double> KeyReader::composition() {
  const toml::node& node = table_->require(key_, "", "a composition", "a table");
  TableReader reader = table_->below(key_, node);
  std::map<std::string, double> fractions;
  double sum = 0.0;
  for (const auto& [key, value] : *node.as_table()) {
    const std::string name(key.str());
    sum += fractions[name] = reader.at(name).number(positive_fraction);
  }
  // Fractions are typed by hand: nine digits distinguish a slip from rounding.
  if (std::abs(sum - 1.0) > 1e-9) fail(fmt::format("fractions sum to {}, allowed: 1", sum));
  return fractions;
}

}  // namespace driver
