// SPDX-License-Identifier: Apache-2.0
#include "base/csv_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <unordered_map>

#include "base/case_reader.hpp"
#include "base/number_text.hpp"
#include "base/result_folder.hpp"
#include "base/text_file.hpp"

namespace driver {
namespace {

struct CsvCell {
  std::string_view text;
  std::size_t column;  // 1-based character position
};

// Place of the next `wanted` outside quotes, or the end of the line.
std::size_t find_outside_quotes(const std::string& line, char wanted, std::size_t begin = 0) {
  bool quoted = false;
  for (; begin < line.size() && (quoted || line[begin] != wanted); ++begin)
    if (line[begin] == '"') quoted = !quoted;
  return begin;
}

constexpr char separators[] = {',', ';', '\t'};
constexpr std::size_t most_titles = 100;  // rows above the header

// True for a blank or a control character. A NUL counts as neither, so that the message shows it.
bool is_blank(char c) {
  return (c > 0 && c <= ' ') || c == 0x7f;
}

// Splits a line into `cells`, which refer to it.
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

// Number of cells without the empty ones at the end: a spreadsheet fills each row up to the widest.
std::size_t filled(const std::vector<CsvCell>& row) {
  std::size_t count = row.size();
  while (count > 0 && row[count - 1].text.empty()) --count;
  return count;
}

// Splits a line, which may be the header, by the separator that makes most cells.
void split_by_most(const std::string& line, std::vector<CsvCell>& cells) {
  std::vector<CsvCell> other;
  split_row(line, separators[0], cells);
  for (const char separator : separators) {
    split_row(line, separator, other);
    if (filled(other) > filled(cells)) cells = other;
  }
}

constexpr std::size_t most_rows = 20'000'000;  // twice as many as a run writes

bool holds_nothing(const std::string& line) {
  const auto is_empty = [](char c) { return is_blank(c) || c == ',' || c == ';' || c == '"'; };
  return std::ranges::all_of(line, is_empty) || comment_of(line).has_value();
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

// Looks for the header: the first row that has all wanted names, by whatever separator. Rows above it are
// titles.
class HeaderSearch {
 public:
  explicit HeaderSearch(const std::vector<std::string>& names) : names_(names) {}

  // Splits the line into `row` and returns its separator if it is the header.
  std::optional<char> match(const std::string& line, std::size_t number, std::vector<CsvCell>& row) {
    for (const char separator : separators) {
      split_row(line, separator, row);
      if (std::ranges::all_of(names_, [&](const auto& name) { return has(row, name); })) return separator;
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
  static bool has(const std::vector<CsvCell>& row, const std::string& name) {
    return std::ranges::find(row, std::string_view(name), &CsvCell::text) != row.end();
  }

  const std::vector<std::string>& names_;
  std::size_t titles_ = 0;
  std::string first_;
  std::size_t first_number_ = 0;
};

// A number with one comma or point.
struct MarkedNumber {
  std::string_view text;
  std::size_t mark = 0;

  char character() const { return text[mark]; }
  std::string with(std::string_view between) const {
    return fmt::format("{}{}{}", text.substr(0, mark), between, text.substr(mark + 1));
  }
  // True for 1 to 3 digits, not 0 at first, before the mark and 3 after it: 101,325 may be 101325.
  bool may_be_thousands() const {
    const auto digits = [](std::string_view part) {
      return std::ranges::all_of(part, [](char c) { return c >= '0' && c <= '9'; });
    };
    auto before = text.substr(0, mark);
    const auto after = text.substr(mark + 1);
    if (before.starts_with('-') || before.starts_with('+')) before.remove_prefix(1);
    return before.size() >= 1 && before.size() <= 3 && before[0] != '0' && digits(before) &&
           after.size() == 3 && digits(after);
  }
};

// Numbers of one file. Beside semicolons or tabs they may have decimal commas, but then all of them: 1.234
// may have a point for thousands.
class NumberReader {
 public:
  NumberReader(const std::filesystem::path& file, char separator, std::size_t header_line)
      : file_(file), separator_(separator), header_line_(header_line) {}

  // Looks for numbers that can only have a decimal comma or point. Those of all columns count.
  void look(const std::vector<CsvCell>& row) {
    if (separator_ == ',' || decimal_.size() == 2) return;
    for (const CsvCell& cell : row) {
      const MarkedNumber number{cell.text, cell.text.find_first_of(",.")};
      if (number.mark == cell.text.npos || decimal_.find(number.character()) != decimal_.npos) continue;
      if (!number.may_be_thousands() && file_number_of(number.with("."))) decimal_ += number.character();
    }
  }

  double read(const std::vector<CsvCell>& row, std::size_t index, std::size_t line) {
    if (index >= row.size())
      fail_at(file_, line, 1, fmt::format("has {} columns, needed: {}", row.size(), index + 1));
    const CsvCell& cell = row[index];
    const auto value = file_number_of(with_point(cell, line));
    if (!value)
      fail_at(file_, line, cell.column,
              fmt::format("'{}' is not a finite number{}", cell.text, advice(cell.text, line)));
    return *value;
  }

  // After all rows. Throws CaseError if marks may be between thousands in all numbers.
  void check_marks() const {
    if (!doubt_ || decimal_.find(mark_) != decimal_.npos) return;
    const MarkedNumber number{doubt_->text, doubt_->text.find(mark_)};
    fail_at(file_, doubt_->line, doubt_->column,
            fmt::format("'{0}' may be {1} or {2}, as every {3} of the file has three digits after it; "
                        "write {0}0 or {2}",
                        number.text, number.with("."), number.with(""), mark_ == ',' ? "comma" : "point"));
  }

  // Throws CaseError for more cells than names: a decimal comma, or a column without a name.
  void check_width(const std::vector<CsvCell>& row, std::size_t width, std::size_t line) const {
    const std::size_t cells = filled(row);
    if (cells > width)
      fail_at(file_, line, 1,
              fmt::format("has {} columns, but the header {}{}", cells, width,
                          separator_ == ',' ? decimal_comma : ""));
  }

 private:
  static constexpr const char* decimal_comma = "; decimal commas need semicolons between columns";

  const char* advice(std::string_view text, std::size_t line) const {
    if (separator_ == ',' && text.find(',') != text.npos) return decimal_comma;
    const bool is_word =
        text.find_first_of("0123456789") == text.npos && text.find_first_not_of(".,+-") != text.npos;
    return is_word && line == header_line_ + 1 ? "; put # before a row of units" : "";
  }

  std::string_view with_point(const CsvCell& cell, std::size_t line) {
    const auto mark = cell.text.find_first_of(",.");
    if (separator_ == ',' || mark == cell.text.npos) return cell.text;
    if (mark_ == 0) mark_ = cell.text[mark], line_ = line;
    if (cell.text.find(mark_ == ',' ? '.' : ',') != cell.text.npos)
      fail_at(file_, line, cell.column,
              fmt::format("'{}' is ambiguous, as line {} has a decimal {}; allowed: the same in all numbers, "
                          "and nothing between thousands",
                          cell.text, line_, mark_ == ',' ? "comma" : "point"));
    if (!doubt_ && MarkedNumber{cell.text, mark}.may_be_thousands())
      doubt_ = {std::string(cell.text), line, cell.column};
    if (mark_ == '.') return cell.text;
    text_ = cell.text;
    text_[mark] = '.';
    return text_;
  }

  struct Doubt {
    std::string text;
    std::size_t line, column;
  };

  const std::filesystem::path& file_;
  char separator_;
  std::size_t header_line_;
  std::string decimal_;         // of comma and point, those that can only be decimal
  std::optional<Doubt> doubt_;  // the first number whose mark may be between thousands
  char mark_ = 0;               // the first decimal comma or point
  std::size_t line_ = 0;        // its line
  std::string text_;
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
