// SPDX-License-Identifier: Apache-2.0
// The files that a command reads, which it must not overwrite, and the id that follows from them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/case_reader.hpp"

namespace driver::commands {

/// Throws CaseError if the output file of `option` is one of the input files.
void refuse_same_file(const char* option, const std::filesystem::path& out,
                      const std::vector<std::filesystem::path>& inputs);
/// Throws CaseError for a pipe or a device, because the command reads the file more than once.
void require_file(const std::filesystem::path& file);
/// Throws CaseError if one of the inputs is among the results in the folder of --out, which are removed.
void refuse_inputs(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& inputs);
/// A case and the files that it names. Throws CaseError.
std::vector<std::filesystem::path> input_files(const std::filesystem::path& file,
                                               const std::vector<std::string>& overrides);

/// Id of the results of `command` with `options` for cases that have been read.
std::string id_of(const std::string& command, const std::vector<std::string>& options,
                  const std::vector<const CaseDocument*>& cases);

}  // namespace driver::commands
