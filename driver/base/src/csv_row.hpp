// SPDX-License-Identifier: Apache-2.0
// Cells of one line of a CSV file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace driver {

struct CsvCell {
  std::string_view text;
  std::size_t column;  // 1-based character position
};

inline constexpr char separators[] = {',', ';', '\t'};

/// True for a blank or a control character. A NUL counts as neither, so that the message shows it.
bool is_blank(char c);

/// Splits a line into `cells`, which refer to it.
void split_row(const std::string& line, char separator, std::vector<CsvCell>& cells);
/// The same for a line that may be the header, by the separator that makes most cells.
void split_by_most(const std::string& line, std::vector<CsvCell>& cells);

/// Number of cells without the empty ones at the end: a spreadsheet fills each row up to the widest.
std::size_t filled(const std::vector<CsvCell>& row);

/// Throws CaseError `file:line:column: message`.
[[noreturn]] void fail_at(const std::filesystem::path& file, std::size_t line, std::size_t column,
                          const std::string& message);

}  // namespace driver
