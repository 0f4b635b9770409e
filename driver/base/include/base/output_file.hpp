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

/// Results are not numbers, or could not be written although the folder was writable at the start (exit code
/// 3).
class WriteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file is first written under its name plus this suffix (and a number if that exists), and then renamed.
inline constexpr const char* part_suffix = ".gasjet-part";

/// Replaces a file in one step: a reader sees the old text or the new one, and a full disk leaves the old
/// one. Follows links, and writes directly to devices and pipes. Throws OutputError if the file cannot be
/// opened, WriteError if it cannot be written.
void replace_file(const std::filesystem::path& file, const std::string& text);

/// A file that grows by whole rows. A row that does not fit on the disk is left out.
class GrowingFile {
 public:
  /// `keep`: appends to the existing file. Throws OutputError if it cannot be opened.
  explicit GrowingFile(const std::filesystem::path& file, bool keep = false);
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;
  /// Throws WriteError if `rows` do not fit. The rows that fit are then in the file, none of them cut.
  void append(std::string_view rows);

 private:
  std::filesystem::path file_;
  int descriptor_;
};

}  // namespace driver
