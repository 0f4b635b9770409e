// SPDX-License-Identifier: Apache-2.0
// The runs of a plan that have ended, in a folder of results and in those of its shares: none of them is
// computed again.
#pragma once

#include <chrono>
#include <map>
#include <memory>

#include "base/output_file.hpp"
#include "many_runs/crew.hpp"
#include "many_runs/run_record.hpp"
#include "many_runs/share.hpp"

namespace driver {

/// A file, and the digits of what it held when it was first read.
struct RunInput {
  std::filesystem::path file;
  std::string digits;
};

/// Each file has a line of JSON for each run, after a line that names the build and the files that the runs
/// have read. A line that a kill tore is not there.
class RunJournal {
 public:
  using Runs = std::map<long, RunRecord>;  // by their numbers

  /// Of runs that read `inputs`, which stand in the journal.
  explicit RunJournal(RunShape shape, std::vector<RunInput> inputs = {})
      : shape_(std::move(shape)), inputs_(std::move(inputs)) {}

  /// Reads the shares below `folder`: see shares_in(). Of a run that two have computed the first share's
  /// counts. Throws CaseError for runs that have read other files, and for a damaged line.
  void read_shares(const std::filesystem::path& folder, const std::string& run);
  /// Keeps runs in the journal of `folder` from now on, after those that it has: these are read, too.
  void open(ResultFolder& folder);

  const Runs& runs() const { return runs_; }
  /// What opened the first file, as its build wrote it.
  const Provenance& build() const { return build_; }
  const RunRecord* find(long number) const;
  /// A run that has ended; throws WriteError.
  const RunRecord& keep(CrewResult result);
  /// Reads what other shares have appended if that is due, once a second or less often. Their faults are
  /// those of the next command that reads them.
  void look_at_shares();

 private:
  // How far a file has been read.
  struct Place {
    std::uintmax_t bytes = 0;
    int lines = 0;
    bool has_head = false;
  };
  void read(const std::filesystem::path& file);
  void read_line(const std::string& line, const std::filesystem::path& file, Place& read);
  bool read_head(const std::string& line, const std::string& place);

  RunShape shape_;
  std::vector<RunInput> inputs_;
  Runs runs_;
  Provenance build_;
  std::map<std::filesystem::path, Place> read_;
  std::filesystem::path shares_;  // folder
  std::filesystem::path own_;     // file
  std::unique_ptr<GrowingFile> file_;
  std::chrono::steady_clock::time_point next_look_{};
};

}  // namespace driver
