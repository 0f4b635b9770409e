// SPDX-License-Identifier: Apache-2.0
// The folder that a command writes: locked, marked as running until the command ends, and of one run.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace driver {

/// Lines `# key: value` that open each result file.
using Provenance = std::vector<std::pair<std::string, std::string>>;

/// The result folder cannot be made, locked or written, or holds files of others (exit code 2).
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

/// Version, commit, compiler and flags of this build, as the results name them.
Provenance build_lines();

/// Tells the results of one computation from those of another: 16 hexadecimal digits of what the results
/// follow from, which are `facts`, the contents of `files`, and the build. Equal computations have equal ids.
std::string run_id(const std::vector<std::string>& facts, const std::vector<std::filesystem::path>& files);

/// Tells a text from others: 16 hexadecimal digits.
std::string digits_of(std::string_view text);
/// The same of what a file holds; nothing if it cannot be read. All pipes have the same.
std::optional<std::string> digits_of_file(const std::filesystem::path& file);

/// `text` in UTF-8 on one line, whatever bytes it holds: control characters stand as \xNN.
std::string one_line(const std::string& text);
/// `lines` as `# key: value` in UTF-8, each on one line whatever bytes the value holds.
std::string comment_lines(const Provenance& lines);

/// Replaces a file in one step: a reader sees the old text or the new one, and a full disk leaves the old
/// one. Follows links, and writes straight into what is no regular file. Throws OutputError when it cannot be
/// opened, WriteError when it takes no more.
void replace_file(const std::filesystem::path& file, const std::string& text);

/// A file that grows by whole rows: a row that does not fit on the disk is left out.
class GrowingFile {
 public:
  /// `keep`: after what it holds. Throws OutputError when it cannot be opened.
  explicit GrowingFile(const std::filesystem::path& file, bool keep = false);
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;
  /// Throws WriteError when `rows` do not fit: those that do are there, and none is torn.
  void append(std::string_view rows);

 private:
  std::filesystem::path file_;
  int descriptor_;
};

/// What `gasjet.status` says: the run that wrote the folder, how it ended, and the files that it wrote.
struct FolderStatus {
  std::string command;  // of gasjet
  std::string run;
  std::string status;  // "running" until the command ends, then how it ended
  std::set<std::string, std::less<>> files;
  /// [bytes] of the files when the command ended; of a killed one there are none.
  std::map<std::string, std::uintmax_t, std::less<>> sizes;
};
inline constexpr const char* status_file = "gasjet.status";
/// A file is written beside its place, under its name and this, and then renamed. A number follows if a file
/// of that name is there.
inline constexpr const char* part_suffix = ".gasjet-part";
inline constexpr const char* status_head =
    "# Written by gasjet: the run that wrote this folder, how it ended, its files.";
/// The finished parts of work that is not finished: the same command goes on from there.
inline constexpr const char* journal_file = "journal.jsonl";

/// Nothing if there is no status file. Throws OutputError for a file of that name which is none.
std::optional<FolderStatus> read_status(const std::filesystem::path& folder);

/// Throws CaseError when the folder of `file` says that its run has not ended, that its runs were interrupted
/// before all were done, or that the file is of another run, and when the table's last row is cut. Files that
/// it does not list are the user's own.
void require_whole(const std::filesystem::path& file);
/// The same for a file that is no table, and which says itself of which run it is.
void require_whole(const std::filesystem::path& file, const std::string& run);

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
