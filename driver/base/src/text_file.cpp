// SPDX-License-Identifier: Apache-2.0
#include "base/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

namespace driver {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // of UTF-8, written by spreadsheets

std::ifstream open_text(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored))
    throw FileError(fmt::format("{}: is a folder, expected: a file", file.string()));
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw FileError(fmt::format("{}: no such file, or not readable", file.string()));
  return stream;
}

}  // namespace

LineReader::LineReader(const std::filesystem::path& file) : file_(file), stream_(open_text(file)) {}

bool LineReader::next(std::string& line) {
  constexpr std::size_t longest = 1u << 20, much = 1u << 16;
  std::size_t end = chunk_.find('\n', at_);
  while (end == std::string::npos && stream_) {
    chunk_.erase(0, at_);
    at_ = 0;
    const std::size_t before = chunk_.size();
    chunk_.resize(before + much);
    stream_.read(chunk_.data() + before, much);
    chunk_.resize(before + static_cast<std::size_t>(stream_.gcount()));
    if (stream_.bad()) throw FileError(fmt::format("{}: cannot be read to its end", file_.string()));
    end = chunk_.find('\n', before);
    if (end == std::string::npos && chunk_.size() > longest)
      throw FileError(fmt::format("{}:{}:1: the line is longer than 1 MiB", file_.string(), number_ + 1));
  }
  if (end == std::string::npos && at_ == chunk_.size()) return false;
  end = std::min(end, chunk_.size());
  line.assign(chunk_, at_, end - at_);
  at_ = std::min(end + 1, chunk_.size());
  if (number_++ == 0 && line.starts_with(byte_order_mark)) line.erase(0, byte_order_mark.size());
  // Ends of lines of old Macs: the whole file would be one line, perhaps a comment.
  if (const auto at = line.find('\r');
      at != std::string::npos && line.find_first_not_of('\r', at) != std::string::npos)
    throw FileError(fmt::format(
        "{}:{}:{}: a carriage return within a line, allowed: lines that end with a line feed, or with both",
        file_.string(), number_, at + 1));
  return true;
}

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream = open_text(file);
  constexpr std::size_t most = 64u << 20;  // longer than any case; a device may be endless
  std::string text;
  std::array<char, 1u << 16> chunk;
  do {
    stream.read(chunk.data(), chunk.size());
    text.append(chunk.data(), static_cast<std::size_t>(stream.gcount()));
  } while (stream && text.size() <= most);
  if (stream.bad()) throw FileError(fmt::format("{}: cannot be read to its end", file.string()));
  if (text.size() > most) throw FileError(fmt::format("{}: is longer than 64 MiB", file.string()));
  if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
  return text;
}

}  // namespace driver
