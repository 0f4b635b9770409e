// SPDX-License-Identifier: Apache-2.0
#include "results/mesh_reader.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "headers.hpp"
#include "mesh/polygons.hpp"
#include "mesh/stl.hpp"
#include "soup.hpp"

namespace driver {
namespace {

using mesh::MeshFileError;

std::string ending_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

std::string bytes_of(const std::filesystem::path& path) {
  std::error_code ignored;
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path, ignored))
    throw MeshFileError(path.string(), 0, 0, "cannot be opened for reading");
  std::string bytes;
  std::array<char, 1u << 16> chunk;  // a device may be endless
  do {
    file.read(chunk.data(), chunk.size());
    bytes.append(chunk.data(), static_cast<std::size_t>(file.gcount()));
  } while (file && bytes.size() <= mesh::largest_mesh_file);
  if (file.bad()) throw MeshFileError(path.string(), 0, 0, "cannot be read");
  if (bytes.size() > mesh::largest_mesh_file)
    throw MeshFileError(path.string(), 0, 0,
                        "is longer than " + std::to_string(mesh::largest_mesh_file >> 20) + " MiB");
  return bytes;
}

[[noreturn]] void fail(const std::filesystem::path& path, std::size_t line, const std::string& message) {
  throw MeshFileError(path.string(), line, line == 0 ? 0 : 1, message);
}

// Number of line breaks in the bytes up to `at`.
std::size_t line_breaks(const std::string& bytes, std::size_t at) {
  return static_cast<std::size_t>(
      std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

// Throws if the file goes on: CGAL reads only what the header announces.
void require_end(const std::filesystem::path& path, const Soup& soup, const std::string& bytes,
                 const std::string& announced) {
  const std::size_t more = bytes.find_first_not_of(" \t\r\n", soup.stopped_at);
  if (more == std::string::npos) return;
  fail(path, soup.is_text ? 1 + line_breaks(bytes, more) : 0,
       "the header announces " + announced + ", but the file continues for " +
           std::to_string(bytes.size() - more) + " bytes" + (soup.is_text ? " here" : "") +
           "; correct the header");
}

mesh::Mesh mesh_of(const std::filesystem::path& path, SoupFormat format, const std::string& bytes) {
  const std::string announced = check_header(path, format, bytes);
  const Soup soup = read_soup(format, bytes);
  if (!soup.fault.empty())
    fail(path, soup.is_text ? 1 + line_breaks(bytes, std::min(soup.stopped_at, bytes.size())) : 0,
         soup.fault);
  if (format == SoupFormat::ply) require_end(path, soup, bytes, announced);
  try {
    return mesh::mesh_of_polygons(soup.nodes, soup.polygons);
  } catch (const std::invalid_argument& error) {
    fail(path, 0, error.what());
  }
}

}  // namespace

mesh::Mesh read_any_mesh(const std::filesystem::path& path) {
  const std::string ending = ending_of(path);
  if (ending != ".stl" && ending != ".ply") {
    static const std::string others[] = {".obj", ".k",   ".key", ".dyn", ".rad",
                                         ".off", ".vtk", ".vtu", ".vtp", ".msh"};
    if (std::find(std::begin(others), std::end(others), ending) == std::end(others))
      fail(path, 0, std::string("a mesh file ends with one of ") + mesh_endings);
    return mesh::read_mesh(path);
  }
  const std::string bytes = bytes_of(path);
  if (ending == ".stl") {
    // Text may follow a byte order mark.
    if (mesh::is_stl_text(bytes) || bytes.starts_with("\xEF\xBB\xBF")) return mesh::read_mesh(path);
    return mesh_of(path, SoupFormat::stl, bytes);
  }
  return mesh_of(path, SoupFormat::ply, bytes);
}

}  // namespace driver
