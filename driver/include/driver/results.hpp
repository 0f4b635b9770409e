// SPDX-License-Identifier: Apache-2.0
// The files of a run: history.csv, energy.csv, summary.json.
#pragma once

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "driver/columns.hpp"

namespace driver {

/// Lines `# key: value` that open each result file.
using Provenance = std::vector<std::pair<std::string, std::string>>;

/// Case, version, commit, compiler, options, date (UTC) of a run.
Provenance provenance(const std::filesystem::path& case_file, const std::vector<std::string>& overrides);

/// The result folder cannot be made or written (exit code 2).
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Results could not be written although the folder was writable at the start, or are no numbers (exit code
/// 3).
class WriteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A CSV file of chosen columns, readable at any moment of the run: numbers in the shortest form that reads
/// back to the same double. Throws OutputError when the file cannot be opened.
class CsvWriter {
 public:
  CsvWriter(const std::filesystem::path& file, const Provenance& provenance, std::vector<Column> columns);
  /// Throws WriteError, and leaves the row out, when a value is not finite or the file takes no more.
  void write(const Scene& scene, const State& state);
  void flush();

 private:
  std::filesystem::path file_;
  std::ofstream stream_;
  std::vector<Column> columns_;
};

/// Makes `folder` (and its parents) and proves that files can be written there, those of `names` that are
/// there already too. Throws OutputError.
void prepare_output(const std::filesystem::path& folder, std::initializer_list<const char*> names = {});

}  // namespace driver
