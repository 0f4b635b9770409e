// SPDX-License-Identifier: Apache-2.0
// The files of a run: history.csv, energy.csv, summary.json.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result_folder.hpp"
#include "engine/columns.hpp"

namespace driver {

/// Case, version, commit, compiler, options, date (UTC) of a run.
Provenance provenance(const std::filesystem::path& case_file, const std::vector<std::string>& overrides);
/// The same with the id of the run.
Provenance provenance(const std::filesystem::path& case_file, const std::vector<std::string>& overrides,
                      const std::string& run);

/// A CSV file of chosen columns, readable at any moment of the run: numbers in the shortest form that reads
/// back to the same double. It has whole rows only.
class CsvWriter {
 public:
  /// Throws OutputError when the file cannot be opened.
  CsvWriter(ResultFolder& folder, const std::string& name, std::vector<Column> columns);
  /// Throws WriteError, and leaves the row out, when a value is not finite or the file takes no more.
  void write(const Scene& scene, const State& state);
  /// Rows of more than a second ago are in the file from here on. Cheap enough to be called every step.
  void keep_up();
  void flush();

 private:
  GrowingFile file_;
  std::vector<Column> columns_;
  std::string pending_;  // whole rows
  std::chrono::steady_clock::time_point flushed_;
};

}  // namespace driver
