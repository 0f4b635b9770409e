// SPDX-License-Identifier: Apache-2.0
#include "mesh_text.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "mesh/mesh_file.hpp"

namespace mesh {

std::string shown(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string result = "\"";
  for (const char c : text.substr(0, longest)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + (text.size() > longest ? "...\"" : "\"");
}

std::string number_fault(std::string_view text, double& value) {
  std::string_view digits = text;
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range) return shown(text) + " is beyond double range";
  if (error != std::errc() || end != digits.data() + digits.size()) return shown(text) + " is not a number";
  return std::isfinite(value) ? "" : shown(text) + " is not finite";
}

void append_number(double value, std::string& text) {
  std::array<char, 32> buffer;
  text.append(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr);
}

std::string read_text(const std::filesystem::path& path) {
  std::error_code ignored;
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path, ignored))
    throw MeshFileError(path.string(), 0, 0, "cannot be opened for reading");
  constexpr std::size_t most = largest_mesh_file;  // a device may be endless
  std::string text;
  std::array<char, 1u << 16> chunk;
  do {
    file.read(chunk.data(), chunk.size());
    text.append(chunk.data(), static_cast<std::size_t>(file.gcount()));
  } while (file && text.size() <= most);
  if (text.size() > most)
    throw MeshFileError(path.string(), 0, 0, "is longer than " + std::to_string(most >> 20) + " MiB");
  if (file.bad()) throw MeshFileError(path.string(), 0, 0, "cannot be read");
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);  // byte order mark of UTF-8
  if (text.find('\n') == std::string::npos)
    std::replace(text.begin(), text.end(), '\r', '\n');  // line ends of old Macs
  return text;
}

namespace {

bool write_straight(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  return static_cast<bool>(file);
}

struct Part {
  std::filesystem::path path;
  std::FILE* file;
};

// Opens a part file of this writer alone: if two write one file at once, each renames a complete one.
Part open_part(const std::filesystem::path& target) {
  for (int n = 0;; ++n) {
    std::filesystem::path path = target.string() + ".gasjet-part" + (n == 0 ? "" : std::to_string(n));
    std::FILE* file = std::fopen(path.c_str(), "wbx");
    if (file || errno != EEXIST) return {std::move(path), file};
  }
}

// Replaces a file in one step: on a full disk the old file stays.
bool replace(const std::filesystem::path& path, const std::string& text) {
  const Part part = open_part(path);
  if (!part.file) return false;
  const bool taken = std::fwrite(text.data(), 1, text.size(), part.file) == text.size();
  std::error_code failed, ignored;
  if (std::fclose(part.file) == 0 && taken)
    std::filesystem::rename(part.path, path, failed);
  else
    failed = std::make_error_code(std::errc::io_error);
  if (failed) std::filesystem::remove(part.path, ignored);
  return !failed;
}

}  // namespace

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::error_code ignored;
  const bool is_there = std::filesystem::exists(path, ignored);
  const bool is_device = is_there && !std::filesystem::is_regular_file(path, ignored);
  const bool may_be_replaced = !is_there || std::ofstream(path, std::ios::app).good();
  const bool written =
      is_device ? write_straight(path, text)
                : may_be_replaced && replace(is_there ? std::filesystem::canonical(path) : path, text);
  if (!written) throw MeshFileError(path.string(), 0, 0, "cannot be written");
}

std::string panel_name(std::string_view text) {
  std::string name(text);
  for (char& c : name)
    if (static_cast<unsigned char>(c) <= ' ' || c == '#') c = '_';
  return name.empty() ? "default" : name;
}

void require_finite_nodes(const Mesh& mesh) {
  if (!mesh.nodes.allFinite())
    throw std::invalid_argument("nodes: a coordinate is not finite; mesh files hold finite ones");
}

}  // namespace mesh
