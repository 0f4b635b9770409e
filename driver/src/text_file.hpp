// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace driver {

/// The whole text of an input file. Throws CaseError for a folder, a file that cannot be read or one of more
/// than 64 MiB.
std::string read_text(const std::filesystem::path& file);

}  // namespace driver
