// SPDX-License-Identifier: Apache-2.0
// Wavefront OBJ files: nodes (v), elements (f) and panels (g, o).
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "membrane/mesh.hpp"

namespace membrane {

/// A mesh file that cannot be read; what() reads `file:line:column: what is wrong`.
class MeshFileError : public std::runtime_error {
 public:
  MeshFileError(const std::string& file, std::size_t line, std::size_t column, const std::string& message);
  std::size_t line() const { return line_; }      // from 1; 0 if the file as a whole is meant
  std::size_t column() const { return column_; }  // from 1; 0 if the file as a whole is meant

 private:
  std::size_t line_;
  std::size_t column_;
};

/// Reads an OBJ file, lengths in metres. Statements: `v x y z [w]` (w ignored); `f` with 3 or 4 corners
/// written i, i/j, i//k or i/j/k, the index counted from 1 or, negative, back from the last node (quads are
/// split along the shorter diagonal); `g`/`o` name (elements that follow belong to that panel; "default"
/// before the first); `#` comments; vt, vn, vp, s, usemtl, mtllib are skipped. Anything else, a number that
/// is not finite, an index without a node above it or a repeated corner throws MeshFileError with line and
/// column. Closedness is not asked here: surface_check.hpp.
Mesh read_obj(const std::filesystem::path& path);

/// The same for text in memory; `name` stands for the file in messages.
Mesh parse_obj(std::string_view text, const std::string& name);

/// OBJ text of a mesh, elements grouped by panel as they come; nodes round-trip bit for bit. Throws
/// std::invalid_argument if a panel name is empty or has white space, or a node is not finite.
std::string format_obj(const Mesh& mesh);

/// Writes format_obj(mesh). Throws MeshFileError (line 0) if the file cannot be written.
void write_obj(const Mesh& mesh, const std::filesystem::path& path);

}  // namespace membrane
