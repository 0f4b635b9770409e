// SPDX-License-Identifier: Apache-2.0
#include "membrane/mesh_file.hpp"

#include <algorithm>
#include <cctype>

#include "membrane/keyword.hpp"
#include "membrane/obj.hpp"
#include "mesh_text.hpp"

namespace membrane {
namespace {

std::string location(const std::string& file, std::size_t line, std::size_t column) {
  return line == 0 ? file : file + ":" + std::to_string(line) + ":" + std::to_string(column);
}

enum class Format { obj, keyword };

Format format_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".obj") return Format::obj;
  if (ending == ".k" || ending == ".key" || ending == ".dyn") return Format::keyword;
  throw MeshFileError(path.string(), 0, 0, "a mesh file ends with .obj, .k, .key or .dyn");
}

}  // namespace

MeshFileError::MeshFileError(const std::string& file, std::size_t line, std::size_t column,
                             const std::string& message)
    : std::runtime_error(location(file, line, column) + ": " + message), line_(line), column_(column) {}

Mesh read_mesh(const std::filesystem::path& path) {
  const auto parse = format_of(path) == Format::obj ? parse_obj : parse_keyword;
  return parse(read_text(path), path.string());
}

void check_mesh_ending(const std::filesystem::path& path) {
  format_of(path);
}

void write_mesh(const Mesh& mesh, const std::filesystem::path& path) {
  const auto format = format_of(path) == Format::obj ? format_obj : format_keyword;
  write_text(path, format(mesh));
}

}  // namespace membrane
