// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/case_reader.hpp"

namespace driver {

/// A file has no readable text. The fault is in the path, not in a line of the file.
class FileError : public CaseError {
 public:
  using CaseError::CaseError;
};

/// Lines of an input file of any length, without a byte order mark.
class LineReader {
 public:
  /// Throws FileError for a folder and a file that cannot be read.
  explicit LineReader(const std::filesystem::path& file);
  /// Reads the next line; false at the end. Throws FileError for a carriage return within a line, and for a
  /// line of more than 1 MiB (a device may be endless).
  bool next(std::string& line);
  std::size_t number() const { return number_; }  // number of the last line, from 1

 private:
  std::filesystem::path file_;
  std::ifstream stream_;
  std::string chunk_;
  std::size_t at_ = 0, number_ = 0;
};

/// The whole text of an input file, without a byte order mark. Throws FileError for a folder, an unreadable
/// file, or one of more than 64 MiB.
std::string read_text(const std::filesystem::path& file);

}  // namespace driver
