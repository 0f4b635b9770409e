// SPDX-License-Identifier: Apache-2.0
// The folder that a command writes: locked, marked as running until the command ends, and of one run.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/folder_status.hpp"
#include "base/output_file.hpp"
#include "base/run_id.hpp"

namespace driver {

/// A folder of results: one that held no files, or that the same command has made. Its status file is locked
/// as long as this lives, says "running" from begin() to end(), "failed" if this goes before, and lists the
/// files of the run before they are written. Only listed files are ever removed or replaced.
class ResultFolder {
 public:
  /// Throws OutputError if `folder` is of another command, or holds files but is of none; `is_known`: the
  /// caller knows that the command has made it.
  static void require_free(const std::filesystem::path& folder, const std::string& command,
                           bool is_known = false);
  /// Makes and locks the folder. Nothing that was there changes. Throws OutputError as require_free(), if the
  /// folder cannot be made or written, and while another command has the lock.
  ResultFolder(std::filesystem::path folder, std::string command, bool is_known = false);
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  /// Marks the folder as running and removes the files of the run before. `lines` open the result files;
  /// their "run" is the id, by default that of all lines but the date. The journal stays if it is of the same
  /// id.
  void begin(const Provenance& lines);
  /// Marks how the run ended: all files are whole. When all is "done" the journal goes.
  void end(const std::string& status);

  const std::filesystem::path& path() const { return path_; }
  const std::string& run() const { return run_; }
  /// Lines that open each file, the id among them.
  const Provenance& lines() const { return lines_; }

  /// Path of a file of the run, which is listed from now on. Throws OutputError if a file that no run has
  /// written is there.
  std::filesystem::path add(const std::string& name);
  /// Writes a whole file of the run. Throws WriteError.
  void write(const std::string& name, const std::string& text);
  void remove(const std::string& name);

 private:
  void lock();
  void leave();
  void mark(std::string_view text, bool anew);

  std::filesystem::path path_;
  std::string command_;
  FolderStatus earlier_;
  Provenance lines_;
  std::string run_;
  std::set<std::string, std::less<>> listed_;
  bool ended_ = false;
  int descriptor_ = -1;
};

}  // namespace driver
