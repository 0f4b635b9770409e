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

/// A CSV file of chosen columns, readable at any moment of the run: it has whole rows only. Numbers have the
/// shortest form that reads back to the same double.
class CsvWriter {
 public:
  /// Throws OutputError when the file cannot be opened.
  CsvWriter(ResultFolder& folder, const std::string& name, std::vector<Column> columns);
  /// Leaves the row out and throws WriteError if a value is not finite or the file cannot grow.
  void write(const Scene& scene, const State& state);
  /// Writes rows older than a second to the file. Cheap enough to be called every step.
  void keep_up();
  void flush();

 private:
  GrowingFile file_;
  std::vector<Column> columns_;
  std::string pending_;  // whole rows
  std::chrono::steady_clock::time_point flushed_;
};

}  // namespace driver
