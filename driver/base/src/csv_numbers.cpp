// SPDX-License-Identifier: Apache-2.0
#include "csv_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number_text.hpp"

namespace driver {
namespace {

constexpr const char* decimal_comma = "; decimal commas need semicolons between columns";

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

}  // namespace

void NumberReader::look(const std::vector<CsvCell>& row) {
  if (separator_ == ',' || decimal_.size() == 2) return;
  for (const CsvCell& cell : row) {
    const MarkedNumber number{cell.text, cell.text.find_first_of(",.")};
    if (number.mark == cell.text.npos || decimal_.find(number.character()) != decimal_.npos) continue;
    if (!number.may_be_thousands() && file_number_of(number.with("."))) decimal_ += number.character();
  }
}

double NumberReader::read(const std::vector<CsvCell>& row, std::size_t index, std::size_t line) {
  if (index >= row.size())
    fail_at(file_, line, 1, fmt::format("has {} columns, needed: {}", row.size(), index + 1));
  const CsvCell& cell = row[index];
  const auto value = file_number_of(with_point(cell, line));
  if (!value)
    fail_at(file_, line, cell.column,
            fmt::format("'{}' is not a finite number{}", cell.text, advice(cell.text, line)));
  return *value;
}

void NumberReader::check_marks() const {
  if (!doubt_ || decimal_.find(mark_) != decimal_.npos) return;
  const MarkedNumber number{doubt_->text, doubt_->text.find(mark_)};
  fail_at(file_, doubt_->line, doubt_->column,
          fmt::format("'{0}' may be {1} or {2}, as every {3} of the file has three digits after it; "
                      "write {0}0 or {2}",
                      number.text, number.with("."), number.with(""), mark_ == ',' ? "comma" : "point"));
}

void NumberReader::check_width(const std::vector<CsvCell>& row, std::size_t width, std::size_t line) const {
  const std::size_t cells = filled(row);
  if (cells > width)
    fail_at(file_, line, 1,
            fmt::format("has {} columns, but the header {}{}", cells, width,
                        separator_ == ',' ? decimal_comma : ""));
}

const char* NumberReader::advice(std::string_view text, std::size_t line) const {
  if (separator_ == ',' && text.find(',') != text.npos) return decimal_comma;
  const bool is_word =
      text.find_first_of("0123456789") == text.npos && text.find_first_not_of(".,+-") != text.npos;
  return is_word && line == header_line_ + 1 ? "; put # before a row of units" : "";
}

std::string_view NumberReader::with_point(const CsvCell& cell, std::size_t line) {
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

}  // namespace driver
