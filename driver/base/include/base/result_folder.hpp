// SPDX-License-Identifier: Apache-2.0
// The folder that a command writes: locked, marked as running until the command ends, and of one run.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/folder_status.hpp"
#include "base/output_file.hpp"
#include "base/run_id.hpp"

namespace driver {

/// A folder of results. Its status file is locked as long as this lives, says "running" from begin() to
/// end(), "failed" if this goes before, and lists the files of the run before they are written: only those
/// are ever removed or replaced.
class ResultFolder {
 public:
  using IsOwn = std::function<bool(const std::string& name)>;

  /// Makes and locks the folder; `is_own`: the names that `command` may write. Nothing that was there
  /// changes. Throws OutputError when that cannot be done, while another has the lock, when the folder is of
  /// another command, and when a file has such a name that no earlier run wrote, or not as it is now.
  ResultFolder(std::filesystem::path folder, std::string command, const IsOwn& is_own);
  /// Throws OutputError, as the constructor does, where a command could not write its results later.
  static void require_free(const std::filesystem::path& folder, const std::string& command,
                           const IsOwn& is_own);
  ResultFolder(std::filesystem::path folder, std::string command, const std::vector<std::string>& names);
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

  /// Path of a file of the run, which is listed from now on.
  std::filesystem::path add(const std::string& name);
  /// Writes a whole file of the run. Throws WriteError.
  void write(const std::string& name, const std::string& text);
  void remove(const std::string& name);

 private:
  static void check(const std::filesystem::path& path, const std::string& command,
                    const std::optional<FolderStatus>& status, const IsOwn& is_own);
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
