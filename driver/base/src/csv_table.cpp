// SPDX-License-Identifier: Apache-2.0
#include "base/csv_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "base/case_reader.hpp"
#include "base/result_folder.hpp"
#include "base/text_file.hpp"
#include "csv_numbers.hpp"
#include "csv_row.hpp"

namespace driver {
namespace {

constexpr std::size_t most_titles = 100;       // rows above the header
constexpr std::size_t most_rows = 20'000'000;  // twice as many as a run writes

bool holds_nothing(const std::string& line) {
  const auto is_empty = [](char c) { return is_blank(c) || c == ',' || c == ';' || c == '"'; };
  return std::ranges::all_of(line, is_empty) || comment_of(line).has_value();
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

// Looks for the header: the first row that has all wanted names, by whatever separator. Rows above it are
// titles.
class HeaderSearch {
 public:
  explicit HeaderSearch(const std::vector<std::string>& names) : names_(names) {}

  // Splits the line into `row` and returns its separator if it is the header.
  std::optional<char> match(const std::string& line, std::size_t number, std::vector<CsvCell>& row) {
    for (const char separator : separators) {
      split_row(line, separator, row);
      if (has_all_names(row)) return separator;
    }
    if (titles_++ == 0) first_ = line, first_number_ = number;
    return std::nullopt;
  }
  bool is_given_up() const { return titles_ == most_titles; }
  // Throws CaseError for a name that the first row of the file does not have.
  void fail(const CsvTable& table) const {
    if (titles_ == 0) return;
    std::vector<CsvCell> row;
    split_by_most(first_, row);
    find_columns(row, table, first_number_);
  }

 private:
  bool has_all_names(const std::vector<CsvCell>& row) const {
    std::unordered_set<std::string_view> texts;
    for (const auto& cell : row) texts.insert(cell.text);
    return std::ranges::all_of(names_, [&](const auto& name) { return texts.contains(name); });
  }

  const std::vector<std::string>& names_;
  std::size_t titles_ = 0;
  std::string first_;
  std::size_t first_number_ = 0;
};

}  // namespace

void CsvTable::fail(std::size_t column, std::size_t row, const std::string& message) const {
  fail_at(file, lines[row], positions[column][row], names[column] + ": " + message);
}

std::optional<std::string> comment_of(const std::string& line) {
  std::size_t begin = 0, end = line.size();
  const auto skip_blanks = [&] {
    while (begin < end && is_blank(line[begin])) ++begin;
  };
  skip_blanks();
  const bool in_quotes = begin < end && line[begin] == '"';
  if (in_quotes) ++begin;
  skip_blanks();
  if (begin >= end || line[begin] != '#') return std::nullopt;
  while (is_blank(line[end - 1]) || line[end - 1] == ',' || line[end - 1] == ';') --end;
  if (in_quotes && line[end - 1] == '"') --end;
  return line.substr(begin, end - begin);
}

std::string no_such_column(const std::string& name, const std::vector<std::string>& header) {
  return fmt::format("{}: no such column, the header has {}", name, fmt::join(header, ", "));
}

CsvHeader read_csv_header(const std::filesystem::path& file,
                          const std::function<bool(const std::string&)>& is_needed) {
  require_whole(file);
  LineReader lines(file);
  std::optional<CsvHeader> first;
  std::vector<CsvCell> cells;
  const auto names = [&] {
    std::vector<std::string> texts;
    cells.resize(std::max<std::size_t>(filled(cells), 1));
    for (const auto& cell : cells) texts.emplace_back(cell.text);
    return texts;
  };
  std::size_t titles = 0;
  for (std::string line; titles < most_titles && lines.next(line);) {
    if (holds_nothing(line)) continue;
    CsvHeader best{lines.number(), {}};
    for (const char separator : separators) {
      split_row(line, separator, cells);
      auto found = names();
      if (found.size() > best.names.size() && std::ranges::any_of(found, is_needed))
        best.names = std::move(found);
    }
    if (!best.names.empty()) return best;
    if (titles++ > 0) continue;
    split_by_most(line, cells);
    first = CsvHeader{lines.number(), names()};
  }
  if (first) return *first;
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
  char separator = ',';
  HeaderSearch header(names);
  std::optional<NumberReader> numbers;  // once the header is read
  for (std::string line; lines.next(line);) {
    if (holds_nothing(line)) continue;
    if (!numbers) {
      if (const auto found = header.match(line, lines.number(), row)) {
        separator = *found;
        numbers.emplace(file, separator, lines.number());
        indices = find_columns(row, table, lines.number());
        width = filled(row);
      } else if (header.is_given_up()) {
        break;
      }
      continue;
    }
    split_row(line, separator, row);
    numbers->check_width(row, width, lines.number());
    numbers->look(row);
    if (table.rows() == most_rows)
      fail_at(file, lines.number(), 1, fmt::format("is more than {} rows", most_rows));
    table.lines.push_back(static_cast<std::uint32_t>(lines.number()));
    for (std::size_t c = 0; c < count; ++c) {
      table.values[c].push_back(numbers->read(row, indices[c], lines.number()));
      table.positions[c].push_back(static_cast<std::uint32_t>(row[indices[c]].column));
    }
  }
  if (numbers)
    numbers->check_marks();
  else
    header.fail(table);
  return table;
}

}  // namespace driver
