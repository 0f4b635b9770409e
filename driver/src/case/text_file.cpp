// SPDX-License-Identifier: Apache-2.0
#include "case/text_file.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <string_view>

namespace driver {

std::string read_text(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored))
    throw FileError(fmt::format("{}: is a folder, a file is expected", file.string()));
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw FileError(fmt::format("{}: no such file, or not readable", file.string()));
  constexpr std::size_t most = 64u << 20;  // no input file is longer; a device may never end
  std::string text;
  std::array<char, 1u << 16> chunk;
  do {
    stream.read(chunk.data(), chunk.size());
    text.append(chunk.data(), static_cast<std::size_t>(stream.gcount()));
  } while (stream && text.size() <= most);
  if (text.size() > most) throw FileError(fmt::format("{}: is longer than 64 MiB", file.string()));
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // of UTF-8, as spreadsheets write it
  if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
  return text;
}

}  // namespace driver
