// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "driver/case_reader.hpp"

namespace driver {

/// No text can be had of a file: a fault of what names it, not of a line in it.
class FileError : public CaseError {
 public:
  using CaseError::CaseError;
};

/// The whole text of an input file, without a byte order mark. Throws FileError for a folder, a file that
/// cannot be read or one of more than 64 MiB.
std::string read_text(const std::filesystem::path& file);

}  // namespace driver
