// SPDX-License-Identifier: Apache-2.0
// Files that are written whole, or by whole rows.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace driver {

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

/// A file is written beside its place, under its name and this, and then renamed. A number follows if a file
/// of that name is there.
inline constexpr const char* part_suffix = ".gasjet-part";

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

}  // namespace driver
