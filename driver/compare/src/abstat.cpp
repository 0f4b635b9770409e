// SPDX-License-Identifier: Apache-2.0
// Layout of a state: a heading `time airbag/cv # volume pressure ...`, then one row for each airbag, in
// fields of 12 (time), 8 (number), five of 15 and five of 11 characters.
#include "abstat.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <sstream>

#include "base/case_reader.hpp"
#include "base/number_text.hpp"
#include "base/text_file.hpp"

namespace driver {
namespace {

constexpr std::size_t kFields = 12, kNumberField = 1;
constexpr std::size_t kWidths[kFields] = {12, 8, 15, 15, 15, 15, 15, 11, 11, 11, 11, 11};

bool is_heading(const std::string& line) {
  return line.find("time") != std::string::npos && line.find("airbag/cv #") != std::string::npos;
}

bool is_blank(const std::string& line) {
  return line.find_first_not_of(" \t\r") == std::string::npos;
}

struct Row {
  double values[kFields] = {};
  std::size_t positions[kFields] = {};
};

Row read_row(const std::filesystem::path& file, std::size_t line_number, const std::string& line) {
  Row row;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < kFields; begin += kWidths[i++]) {
    const auto place = fmt::format("{}:{}:{}", file.string(), line_number, begin + 1);
    if (line.size() < begin + kWidths[i])
      throw CaseError(fmt::format("{}: the row ends in field {} of {}", place, i + 1, kFields));
    const std::string_view field = std::string_view(line).substr(begin, kWidths[i]);
    const auto skip = std::min(field.find_first_not_of(' '), field.size());
    const auto value = file_number_of(field.substr(skip));
    if (!value) throw CaseError(fmt::format("{}: '{}' is not a finite number", place, field));
    if (i == kNumberField && !(*value >= 1.0 && *value <= 1e9 && *value == std::floor(*value)))
      throw CaseError(fmt::format("{}: '{}' is not a whole number from 1 to 1e9", place, field));
    row.values[i] = *value;
    row.positions[i] = begin + skip + 1;
  }
  return row;
}

}  // namespace

CsvTable read_abstat(const std::filesystem::path& file, int volume_number) {
  CsvTable table{file,
                 {"time", "volume", "pressure", "internal_energy", "dm_dt_in", "density", "dm_dt_out",
                  "total_mass", "gas_temp", "surface_area", "reaction"},
                 std::vector<std::vector<double>>(kFields - 1),
                 {},
                 std::vector<std::vector<std::uint32_t>>(kFields - 1)};
  std::istringstream stream(read_text(file));
  std::set<int> present;
  std::size_t line_number = 0;
  bool in_state = false;
  for (std::string line; std::getline(stream, line);) {
    ++line_number;
    if (is_heading(line) || is_blank(line)) {
      in_state = is_heading(line);
      continue;
    }
    if (!in_state) continue;  // the legend at the top of the file
    const Row row = read_row(file, line_number, line);
    present.insert(static_cast<int>(row.values[kNumberField]));
    if (row.values[kNumberField] != volume_number) continue;
    table.lines.push_back(static_cast<std::uint32_t>(line_number));
    for (std::size_t i = 0, c = 0; i < kFields; ++i) {
      if (i == kNumberField) continue;
      table.values[c].push_back(row.values[i]);
      table.positions[c++].push_back(static_cast<std::uint32_t>(row.positions[i]));
    }
  }
  if (table.rows() > 0) return table;
  if (present.empty()) throw CaseError(fmt::format("{}:1:1: no state of an abstat file", file.string()));
  throw CaseError(fmt::format("{}:1:1: volume_number {}: no such airbag; the first is {}", file.string(),
                              volume_number, *present.begin()));
}

}  // namespace driver
