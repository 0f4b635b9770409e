// SPDX-License-Identifier: Apache-2.0
// Numbers in named columns of a CSV file, with the place of each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace driver {

/// The requested columns, in the order of the request. Every number is finite.
struct CsvTable {
  std::filesystem::path file;
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;            // [column][row]
  std::vector<std::uint32_t> lines;                   // [row] 1-based line of the file
  std::vector<std::vector<std::uint32_t>> positions;  // [column][row] 1-based character in that line

  std::size_t rows() const { return lines.size(); }
  /// Throws CaseError `file:line:column: name: message` at a cell.
  [[noreturn]] void fail(std::size_t column, std::size_t row, const std::string& message) const;
};

/// A comment line from its `#` on; empty for another line. (A spreadsheet that saves a file puts comments
/// with commas in quotes, and adds commas up to the widest row.)
std::optional<std::string> comment_of(const std::string& line);

struct CsvHeader {
  std::size_t line = 0;  // 1-based
  std::vector<std::string> names;
};

/// Names in the header row: the first one that has a name for which `is_needed` is true, by any separator.
/// Without such a row among the first 100 it is the first row, by the separator that makes most cells. Throws
/// CaseError if the file cannot be read or has no row.
CsvHeader read_csv_header(const std::filesystem::path& file,
                          const std::function<bool(const std::string&)>& is_needed);

/// Message that a header has no column of this name.
std::string no_such_column(const std::string& name, const std::vector<std::string>& header);

/// Reads a CSV file with a header row, the first one that has all names; `#` lines and empty lines are
/// skipped; quotes, blanks and control characters around a cell are removed. Columns are separated by commas,
/// semicolons or tabs: by that with which the header has the names. Beside the last two, numbers may have
/// decimal commas. Throws CaseError at the place of the fault if
/// - the file cannot be read or has more than 20 million rows,
/// - a column or a cell is missing, or a row has too many cells,
/// - a cell is not a finite number, or has a decimal comma where another has a point,
/// - commas or points beside semicolons or tabs may all stand between thousands, as in 101,325.
CsvTable read_csv(const std::filesystem::path& file, const std::vector<std::string>& names);

}  // namespace driver
