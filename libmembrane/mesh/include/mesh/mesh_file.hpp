// SPDX-License-Identifier: Apache-2.0
// Mesh files by the ending of their name: Wavefront OBJ (.obj), LS-DYNA keyword (.k, .key, .dyn), STL text
// (.stl), OFF (.off), VTK (.vtk, .vtu, .vtp), Gmsh (.msh) and Radioss starter decks (.rad). The last four
// are read, not written.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>

#include "mesh/mesh.hpp"

namespace mesh {

/// A mesh file that cannot be read; what() reads `file:line:column: what is wrong`.
class MeshFileError : public std::runtime_error {
 public:
  /// Line and column count from 1. Both are 0 if the fault concerns the whole file; what() then names
  /// neither.
  MeshFileError(const std::string& file, std::size_t line, std::size_t column, const std::string& message);
  std::size_t line() const { return line_; }      // from 1; 0: the whole file
  std::size_t column() const { return column_; }  // from 1; 0: the whole file

 private:
  std::size_t line_;
  std::size_t column_;
};

/// Text of a file that a deck includes by this name. Throws MeshFileError.
using IncludedFile = std::function<std::string(const std::string& name)>;

/// [bytes] longest file that is read: some four million elements.
inline constexpr std::size_t largest_mesh_file = std::size_t{256} << 20;

/// Reads a mesh, lengths in metres, by the parsers of obj.hpp, keyword.hpp, radioss.hpp, stl.hpp,
/// off.hpp, vtk.hpp and gmsh.hpp. Files that a deck includes are in its folder or in folders below. Throws
/// MeshFileError for another ending, a file that cannot be read or is too long, and as the parsers do.
Mesh read_mesh(const std::filesystem::path& path);

/// Throws MeshFileError (line 0) if the name has no ending of a writable format.
void check_mesh_ending(const std::filesystem::path& path);

/// Writes a mesh in the format of the file's ending. If that fails, an old file stays as it was. Throws
/// MeshFileError (line 0) for another ending or if the file cannot be written, and std::invalid_argument for
/// a mesh that the format cannot represent.
void write_mesh(const Mesh& mesh, const std::filesystem::path& path);

}  // namespace mesh
