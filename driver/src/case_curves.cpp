// SPDX-License-Identifier: Apache-2.0
// Curves and compositions of a case file, and curves that stand in a CSV beside it.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <fstream>

#include "driver/case_reader.hpp"
#include "toml_library.hpp"

namespace driver {
namespace {

struct CsvCell {
  std::string text;
  std::size_t column;  // 1-based character position
};

std::vector<CsvCell> split_row(const std::string& line) {
  std::vector<CsvCell> cells;
  std::size_t begin = 0;
  while (begin <= line.size()) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    std::size_t first = begin, last = end;
    while (first < last && (line[first] == ' ' || line[first] == '\t')) ++first;
    while (last > first && (line[last - 1] == ' ' || line[last - 1] == '\t' || line[last - 1] == '\r'))
      --last;
    cells.push_back({line.substr(first, last - first), first + 1});
    begin = end + 1;
  }
  return cells;
}

[[noreturn]] void fail_at(const std::filesystem::path& file, std::size_t line, std::size_t column,
                          const std::string& message) {
  throw CaseError(fmt::format("{}:{}:{}: {}", file.string(), line, column, message));
}

std::size_t column_index(const std::vector<CsvCell>& header, const std::string& name,
                         const std::filesystem::path& file, std::size_t line) {
  std::vector<std::string> names;
  for (const auto& cell : header) {
    if (cell.text == name) return names.size();
    names.push_back(cell.text);
  }
  fail_at(file, line, 1, fmt::format("{}: no such column, the header has {}", name, fmt::join(names, ", ")));
}

double cell_number(const std::vector<CsvCell>& row, std::size_t index, const std::filesystem::path& file,
                   std::size_t line) {
  if (index >= row.size())
    fail_at(file, line, 1, fmt::format("has {} columns, {} are needed", row.size(), index + 1));
  const CsvCell& cell = row[index];
  double value = 0.0;
  const char* end = cell.text.data() + cell.text.size();
  const auto [stop, error] = std::from_chars(cell.text.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value))
    fail_at(file, line, cell.column, fmt::format("'{}': a finite number is allowed", cell.text));
  return value;
}

void check_knots(const CurveData& curve, const std::function<void(const std::string&)>& fail) {
  if (curve.time.size() != curve.value.size())
    fail(
        fmt::format("has {} times and {} values, as many are needed", curve.time.size(), curve.value.size()));
  if (curve.time.size() < 2) fail(fmt::format("has {} knots, 2 or more are needed", curve.time.size()));
  for (std::size_t i = 1; i < curve.time.size(); ++i)
    if (!(curve.time[i] > curve.time[i - 1]))
      fail(fmt::format("knot {} at {} s follows {} s: knots in strictly rising order are allowed", i + 1,
                       curve.time[i], curve.time[i - 1]));
}

}  // namespace

CurveData read_curve_csv(const std::filesystem::path& file, const std::string& time_column,
                         const std::string& value_column) {
  std::ifstream stream(file);
  if (!stream) throw CaseError(fmt::format("{}: no such file, or not readable", file.string()));
  CurveData curve;
  std::vector<CsvCell> header;
  std::size_t time_index = 0, value_index = 0, line_number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++line_number;
    if (line.empty() || line[0] == '#' || line == "\r") continue;
    const auto row = split_row(line);
    if (header.empty()) {
      header = row;
      time_index = column_index(header, time_column, file, line_number);
      value_index = column_index(header, value_column, file, line_number);
      continue;
    }
    curve.time.push_back(cell_number(row, time_index, file, line_number));
    curve.value.push_back(cell_number(row, value_index, file, line_number));
  }
  check_knots(curve, [&](const std::string& message) {
    fail_at(file, line_number, 1, value_column + ": " + message);
  });
  return curve;
}

CurveData TableReader::curve_of_table(const std::string& key, TableReader&& reader, Bounds bounds) const {
  CurveData curve;
  if (reader.has("file")) {
    const auto file = beside_case(reader.text("file"));
    curve = read_curve_csv(file, reader.text("time_column", "time_s"), reader.text("column"));
    for (const double value : curve.value)
      if (value < bounds.low || value > bounds.high || (bounds.open_low && value == bounds.low))
        fail(key, fmt::format("{} holds {}, {} is allowed", file.string(), value, bounds.text));
  } else {
    curve.time = reader.numbers("time", any_number);
    curve.value = reader.numbers("value", bounds);
    check_knots(curve, [&](const std::string& message) { fail(key, message); });
  }
  reader.finish();
  return curve;
}

CurveData TableReader::curve(const std::string& key, Bounds bounds) {
  const toml::node& node = require(key, "a number or a curve");
  if (node.is_table()) return curve_of_table(key, table(key), bounds);
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
