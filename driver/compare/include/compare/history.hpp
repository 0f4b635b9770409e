// SPDX-License-Identifier: Apache-2.0
// Histories of this program and of others.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace driver {

/// Columns over strictly rising times, in SI units.
struct History {
  std::vector<double> time;                                          // [s]
  std::vector<std::pair<std::string, std::vector<double>>> columns;  // name and values, one for each time
  int runs = 1;                                                      // number of runs that the columns are
                                                                     // means of
  /// Quantities of the map that the reference does not have, with their positions in the map.
  std::vector<std::string> left_out = {};

  /// Values of a column; nullptr if it does not exist.
  const std::vector<double>* find(const std::string& name) const;
};

/// Reads a history. Without a map, `file` is a CSV file with a column `time_s`; every other column is a
/// quantity. With a map (TOML, docs/case_files.md), `file` has another format, and the map names its columns,
/// units and offsets. Throws CaseError, at the place of the fault, for
/// - a file that cannot be read, or a text that is not a number,
/// - a band or standard error below 0, times that do not rise, or fewer than 3 rows,
/// - an ensemble without its number of runs.
History read_history(const std::filesystem::path& file, const std::filesystem::path& map = {});
/// The same for a comparison with `reference`, of the quantities `only` (all if empty). A column that the map
/// gives for such a quantity must be in the file. A name in the map must not look like a misspelt name of the
/// reference; other names that the reference does not have are ignored, because a map serves many scenes.
History read_history(const std::filesystem::path& file, const std::filesystem::path& map,
                     const History& reference, const std::vector<std::string>& only = {});

/// Suffix of a column that holds the half width of the error band of the column before it.
inline constexpr const char* band_suffix = "_band";
/// Suffix of the standard error of a mean, and of the scatter (standard deviation) of a run about it.
inline constexpr const char* standard_error_suffix = "_standard_error";
inline constexpr const char* scatter_suffix = "_scatter";

}  // namespace driver
