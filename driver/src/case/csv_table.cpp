// SPDX-License-Identifier: Apache-2.0
#include "case/csv_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <string_view>
#include <unordered_map>

#include "case/number_text.hpp"
#include "case/text_file.hpp"
#include "driver/case_reader.hpp"
#include "driver/result_folder.hpp"

namespace driver {
namespace {

struct CsvCell {
  std::string_view text;
  std::size_t column;  // 1-based character position
};

// Where a cell ends: at the next comma, outside quotes.
std::size_t cell_end(const std::string& line, std::size_t begin) {
  bool quoted = false;
  for (; begin < line.size() && (quoted || line[begin] != ','); ++begin)
    if (line[begin] == '"') quoted = !quoted;
  return begin;
}

// Into `cells`, which stand in the line.
void split_row(const std::string& line, std::vector<CsvCell>& cells) {
  const auto is_blank = [&](std::size_t i) { return line[i] == ' ' || line[i] == '\t' || line[i] == '\r'; };
  cells.clear();
  std::size_t begin = 0;
  while (begin <= line.size()) {
    const std::size_t end = cell_end(line, begin);
    std::size_t first = begin, last = end;
    const auto trim = [&] {
      while (first < last && is_blank(first)) ++first;
      while (last > first && is_blank(last - 1)) --last;
    };
    trim();
    if (last - first >= 2 && line[first] == '"' && line[last - 1] == '"') {
      ++first, --last;
      trim();
    }
    cells.push_back({std::string_view(line).substr(first, last - first), first + 1});
    begin = end + 1;
  }
}

constexpr std::size_t most_rows = 20'000'000;  // twice what a run writes

bool holds_nothing(const std::string& line) {
  return line.empty() || line[0] == '#' || line == "\r";
}

[[noreturn]] void fail_at(const std::filesystem::path& file, std::size_t line, std::size_t column,
                          const std::string& message) {
  throw CaseError(fmt::format("{}:{}:{}: {}", file.string(), line, column, message));
}

std::vector<std::size_t> find_columns(const std::vector<CsvCell>& header, const CsvTable& table,
                                      std::size_t line) {
  std::vector<std::string> present;
  std::unordered_multimap<std::string, std::size_t> places;
  for (const auto& cell : header) {
    places.emplace(cell.text, present.size());
    present.emplace_back(cell.text);
  }
  std::vector<std::size_t> indices;
  for (const auto& name : table.names) {
    const auto count = places.count(name);
    if (count == 0) fail_at(table.file, line, 1, no_such_column(name, present));
    if (count > 1) fail_at(table.file, line, 1, fmt::format("{}: is more than one column", name));
    indices.push_back(places.find(name)->second);
  }
  return indices;
}

double cell_number(const std::vector<CsvCell>& row, std::size_t index, const std::filesystem::path& file,
                   std::size_t line) {
  if (index >= row.size())
    fail_at(file, line, 1, fmt::format("has {} columns, {} are needed", row.size(), index + 1));
  const CsvCell& cell = row[index];
  const auto value = number_of(cell.text);
  if (!value) fail_at(file, line, cell.column, fmt::format("'{}': a finite number is allowed", cell.text));
  return *value;
}

// More cells than names: a decimal comma, or a column without a name. A comma at the end is none.
void check_width(const std::vector<CsvCell>& row, std::size_t width, const std::filesystem::path& file,
                 std::size_t line) {
  const std::size_t cells = row.size() - (row.back().text.empty() ? 1 : 0);
  if (cells > width) fail_at(file, line, 1, fmt::format("has {} columns, the header {}", cells, width));
}

}  // namespace

void CsvTable::fail(std::size_t column, std::size_t row, const std::string& message) const {
  fail_at(file, lines[row], positions[column][row], names[column] + ": " + message);
}

std::string no_such_column(const std::string& name, const std::vector<std::string>& header) {
  const bool other_separator = header.size() == 1 && header.front().find_first_of(";\t") != std::string::npos;
  return fmt::format("{}: no such column, the header has {}{}", name, fmt::join(header, ", "),
                     other_separator ? "; commas are needed between columns" : "");
}

CsvHeader read_csv_header(const std::filesystem::path& file) {
  require_whole(file);
  LineReader lines(file);
  CsvHeader header;
  std::vector<CsvCell> cells;
  for (std::string line; lines.next(line);) {
    if (holds_nothing(line)) continue;
    header.line = lines.number();
    split_row(line, cells);
    for (const auto& cell : cells) header.names.emplace_back(cell.text);
    return header;
  }
  throw CaseError(fmt::format("{}:1:1: has no header row", file.string()));
}

CsvTable read_csv(const std::filesystem::path& file, const std::vector<std::string>& names) {
  require_whole(file);
  LineReader lines(file);
  const std::size_t count = names.size();
  CsvTable table{file, names, std::vector<std::vector<double>>(count), {}, {}};
  table.positions.resize(count);
  std::vector<std::size_t> indices;
  std::vector<CsvCell> row;
  std::size_t width = 0;
  for (std::string line; lines.next(line);) {
    if (holds_nothing(line)) continue;
    split_row(line, row);
    if (indices.empty()) {
      indices = find_columns(row, table, lines.number());
      width = row.size();
      continue;
    }
    check_width(row, width, file, lines.number());
    if (table.rows() == most_rows)
      fail_at(file, lines.number(), 1, fmt::format("is more than {} rows", most_rows));
    table.lines.push_back(static_cast<std::uint32_t>(lines.number()));
    for (std::size_t c = 0; c < count; ++c) {
      table.values[c].push_back(cell_number(row, indices[c], file, lines.number()));
      table.positions[c].push_back(static_cast<std::uint32_t>(row[indices[c]].column));
    }
  }
  return table;
}

}  // namespace driver
