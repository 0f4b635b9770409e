// SPDX-License-Identifier: Apache-2.0
#include "base/run_id.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/build_info.hpp"

namespace driver {
namespace {

// FNV-1a, 64 bits: distinguishes texts that differ by accident.
class Hash {
 public:
  void add(std::string_view text) {
    for (const char c : text) value_ = (value_ ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  }
  // Adds the length too, so that two texts differ from their concatenation.
  void add_whole(std::string_view text) {
    add(fmt::format("{}:", text.size()));
    add(text);
  }
  std::string digits() const { return fmt::format("{:016x}", value_); }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

// Skips pipes, which have been read already; their content is among the facts. False if the file cannot be
// read.
bool add_file(Hash& hash, const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return std::filesystem::exists(file, ignored);
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return false;
  std::array<char, 1u << 16> chunk;
  std::size_t size = 0;
  do {
    stream.read(chunk.data(), chunk.size());
    const auto count = static_cast<std::size_t>(stream.gcount());
    hash.add({chunk.data(), count});
    size += count;
  } while (stream);
  hash.add(fmt::format(":{}", size));
  return !stream.bad();
}

// The program's own file: the commit does not identify a build of changed sources.
std::string program_file() {
  const std::string_view commit = build_info::commit;
  if (!commit.ends_with("-dirty") && commit != "unknown") return {};
  const std::filesystem::path program = "/proc/self/exe";
  std::error_code ignored;
  return fmt::format("{} {}", std::filesystem::file_size(program, ignored),
                     std::filesystem::last_write_time(program, ignored).time_since_epoch().count());
}

}  // namespace

Provenance build_lines() {
  return {{"version", build_info::version},
          {"commit", build_info::commit},
          {"compiler", build_info::compiler},
          {"flags", build_info::flags}};
}

std::string run_id(const std::vector<std::string>& facts, const std::vector<std::filesystem::path>& files) {
  Hash hash;
  for (const auto& [key, value] : build_lines()) hash.add_whole(value);
  hash.add_whole(program_file());
  for (const auto& fact : facts) hash.add_whole(fact);
  for (const auto& file : files) add_file(hash, file);
  return hash.digits();
}

std::string digits_of(std::string_view text) {
  Hash hash;
  hash.add_whole(text);
  return hash.digits();
}

std::optional<std::string> digits_of_file(const std::filesystem::path& file) {
  Hash hash;
  if (!add_file(hash, file)) return std::nullopt;
  return hash.digits();
}

std::string one_line(const std::string& text) {
  // Bytes that are not UTF-8 become U+FFFD.
  const auto clean = nlohmann::json::parse(
      nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  std::string line;
  for (const char c : clean.get<std::string>())
    if (static_cast<unsigned char>(c) < ' ' || c == 0x7f)
      line += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    else
      line += c;
  return line;
}

std::string comment_lines(const Provenance& lines) {
  std::string text;
  for (const auto& [key, value] : lines) text += fmt::format("# {}: {}\n", key, one_line(value));
  return text;
}

}  // namespace driver
