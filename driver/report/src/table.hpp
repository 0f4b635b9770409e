// SPDX-License-Identifier: Apache-2.0
// A table over time for the page: the text of its cells, thinned.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace driver {

struct PageTable {
  std::vector<std::pair<std::string, std::string>> lines;  // `# key: value` above the columns
  std::vector<std::string> columns;
  std::vector<std::pair<std::size_t, std::size_t>> intervals;  // columns NAME_low_UNIT and NAME_high_UNIT
  std::string rows;                                            // as in the file, with commas between cells
  std::size_t kept = 0;                                        // rows kept
  std::size_t total = 0;                                       // rows of the file
  double end = 0.0;                                            // time of the last row [s]
};

/// Reads a CSV file of numbers with a column time_s. Of more than `most` rows it keeps the first, the last,
/// every k-th, and each column's extremes. It reads row by row, so a long file needs little memory. Throws
/// CaseError at the place of the fault if
/// - the file cannot be read or has no rows,
/// - it has no columns, or two of one name,
/// - a cell is missing, surplus, or not a finite number,
/// - the times do not rise,
/// - the lower end of an interval is above the upper one, or a half width is below 0.
PageTable read_page_table(const std::filesystem::path& file, std::size_t most);

}  // namespace driver
