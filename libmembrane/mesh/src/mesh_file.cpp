// SPDX-License-Identifier: Apache-2.0
#include "mesh/mesh_file.hpp"

#include <algorithm>
#include <cctype>
#include <map>

#include "mesh/gmsh.hpp"
#include "mesh/keyword.hpp"
#include "mesh/obj.hpp"
#include "mesh/off.hpp"
#include "mesh/radioss.hpp"
#include "mesh/stl.hpp"
#include "mesh/vtk.hpp"
#include "mesh_text.hpp"

namespace mesh {
namespace {

std::string location(const std::string& file, std::size_t line, std::size_t column) {
  return line == 0 ? file : file + ":" + std::to_string(line) + ":" + std::to_string(column);
}

enum class Format { obj, keyword, radioss, stl, off, vtk, vtk_xml, gmsh };

const std::map<std::string, Format>& formats() {
  static const std::map<std::string, Format> list = {
      {".obj", Format::obj},     {".k", Format::keyword},   {".key", Format::keyword},
      {".dyn", Format::keyword}, {".stl", Format::stl},     {".off", Format::off},
      {".vtk", Format::vtk},     {".vtu", Format::vtk_xml}, {".vtp", Format::vtk_xml},
      {".msh", Format::gmsh},    {".rad", Format::radioss}};
  return list;
}

Format format_of(const std::filesystem::path& path, const char* fault) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto found = formats().find(ending);
  if (found == formats().end()) throw MeshFileError(path.string(), 0, 0, fault);
  return found->second;
}

const std::map<Format, std::string (*)(const Mesh&)>& writers() {
  static const std::map<Format, std::string (*)(const Mesh&)> list = {
      {Format::obj, format_obj}, {Format::keyword, format_keyword}, {Format::stl, format_stl}};
  return list;
}

constexpr const char* kRead =
    "a mesh file ends with .obj, .k, .key, .dyn, .rad, .stl, .off, .vtk, .vtu, .vtp or .msh";
constexpr const char* kWritten = "the name of a mesh that is written ends with .obj, .k, .key, .dyn or .stl";

// what() ends at a NUL.
std::string without_nul(std::string text) {
  std::replace(text.begin(), text.end(), '\0', '?');
  return text;
}

}  // namespace

MeshFileError::MeshFileError(const std::string& file, std::size_t line, std::size_t column,
                             const std::string& message)
    : std::runtime_error(location(file, line, column) + ": " + without_nul(message)),
      line_(line),
      column_(column) {}

Mesh read_mesh(const std::filesystem::path& path) {
  const Format format = format_of(path, kRead);
  const std::string text = read_text(path), name = path.string();
  std::vector<std::filesystem::path> included;
  const IncludedFile beside = [&](const std::string& file) {
    included.push_back(path.parent_path() / file);
    std::error_code ignored;  // a pipe may be endless
    if (!std::filesystem::is_regular_file(included.back(), ignored))
      throw MeshFileError(included.back().string(), 0, 0, "is not a readable file");
    return read_text(included.back());
  };
  const auto with_included = [&](Mesh mesh) {
    mesh.included = std::move(included);
    return mesh;
  };
  switch (format) {
    case Format::obj:
      return parse_obj(text, name);
    case Format::keyword:
      return with_included(parse_keyword(text, name, beside));
    case Format::radioss:
      return with_included(parse_radioss(text, name, beside));
    case Format::stl:
      return parse_stl(text, name);
    case Format::off:
      return parse_off(text, name);
    case Format::vtk:
      return parse_vtk(text, name);
    case Format::vtk_xml:
      return parse_vtk_xml(text, name);
    case Format::gmsh:
      break;
  }
  return parse_gmsh(text, name);
}

void check_mesh_ending(const std::filesystem::path& path) {
  const Format format = format_of(path, kWritten);
  if (!writers().contains(format)) throw MeshFileError(path.string(), 0, 0, kWritten);
}

void write_mesh(const Mesh& mesh, const std::filesystem::path& path) {
  check_mesh_ending(path);
  write_text(path, writers().at(format_of(path, kWritten))(mesh));
}

}  // namespace mesh
