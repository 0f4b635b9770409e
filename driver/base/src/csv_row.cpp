// SPDX-License-Identifier: Apache-2.0
#include "csv_row.hpp"

#include <fmt/format.h>

#include "base/case_reader.hpp"

namespace driver {
namespace {

// Place of the next `wanted` outside quotes, or the end of the line.
std::size_t find_outside_quotes(const std::string& line, char wanted, std::size_t begin = 0) {
  bool quoted = false;
  for (; begin < line.size() && (quoted || line[begin] != wanted); ++begin)
    if (line[begin] == '"') quoted = !quoted;
  return begin;
}

}  // namespace

bool is_blank(char c) {
  return (c > 0 && c <= ' ') || c == 0x7f;
}

void split_row(const std::string& line, char separator, std::vector<CsvCell>& cells) {
  cells.clear();
  std::size_t begin = 0;
  while (begin <= line.size()) {
    const std::size_t end = find_outside_quotes(line, separator, begin);
    std::size_t first = begin, last = end;
    const auto trim = [&] {
      while (first < last && is_blank(line[first])) ++first;
      while (last > first && is_blank(line[last - 1])) --last;
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

std::size_t filled(const std::vector<CsvCell>& row) {
  std::size_t count = row.size();
  while (count > 0 && row[count - 1].text.empty()) --count;
  return count;
}

void split_by_most(const std::string& line, std::vector<CsvCell>& cells) {
  std::vector<CsvCell> other;
  split_row(line, separators[0], cells);
  for (const char separator : separators) {
    split_row(line, separator, other);
    if (filled(other) > filled(cells)) cells = other;
  }
}

void fail_at(const std::filesystem::path& file, std::size_t line, std::size_t column,
             const std::string& message) {
  throw CaseError(fmt::format("{}:{}:{}: {}", file.string(), line, column, message));
}

}  // namespace driver
