// SPDX-License-Identifier: Apache-2.0
// Numbers in the cells of a CSV file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "csv_row.hpp"

namespace driver {

/// Numbers of one file. Beside semicolons or tabs they may have decimal commas, but then all of them: 1.234
/// may have a point for thousands. Its functions throw CaseError at the place of the fault.
class NumberReader {
 public:
  NumberReader(const std::filesystem::path& file, char separator, std::size_t header_line)
      : file_(file), separator_(separator), header_line_(header_line) {}

  /// Looks for numbers that can only have a decimal comma or point. Those of all columns count.
  void look(const std::vector<CsvCell>& row);
  double read(const std::vector<CsvCell>& row, std::size_t index, std::size_t line);
  /// After all rows. Throws if commas or points may be between thousands in all numbers.
  void check_marks() const;
  /// Throws for more cells than names: a decimal comma, or a column without a name.
  void check_width(const std::vector<CsvCell>& row, std::size_t width, std::size_t line) const;

 private:
  struct Doubt {
    std::string text;
    std::size_t line, column;
  };

  const char* advice(std::string_view text, std::size_t line) const;
  std::string_view with_point(const CsvCell& cell, std::size_t line);

  const std::filesystem::path& file_;
  char separator_;
  std::size_t header_line_;
  std::string decimal_;         // of comma and point, those that can only be decimal
  std::optional<Doubt> doubt_;  // the first number whose mark may be between thousands
  char mark_ = 0;               // the first decimal comma or point
  std::size_t line_ = 0;        // its line
  std::string text_;
};

}  // namespace driver
