// SPDX-License-Identifier: Apache-2.0
#include "text_file.hpp"

#include <fmt/format.h>

#include <fstream>

#include "driver/case_reader.hpp"

namespace driver {

std::string read_text(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored))
    throw CaseError(fmt::format("{}: is a folder, a file is expected", file.string()));
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw CaseError(fmt::format("{}: no such file, or not readable", file.string()));
  constexpr std::size_t most = 64u << 20;  // no input file is longer; a device may never end
  std::string text(most + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > most) throw CaseError(fmt::format("{}: is longer than 64 MiB", file.string()));
  return text;
}

}  // namespace driver
