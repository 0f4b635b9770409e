// SPDX-License-Identifier: Apache-2.0
// STL text: triangles by the coordinates of their corners, solids as panels.
#pragma once

#include <string>
#include <string_view>

#include "mesh/mesh_file.hpp"

namespace mesh {

/// True if the bytes are STL text: the first word begins with "solid", and no byte is zero. Some programs
/// begin the header of binary files with that word.
bool is_stl_text(std::string_view bytes);

/// Reads STL text, in capitals or not; lengths are not converted. `name` is the file's name in messages.
/// Corners of equal coordinates are one node; normals are not read. A solid is a panel of its name (blanks
/// and # become _, no name gives "default"). Throws MeshFileError, with line and column, for anything else
/// than solids of facets of three vertices, and a number that is not finite.
Mesh parse_stl(std::string_view text, const std::string& name);

/// STL text of a mesh, one solid for each panel. Numbers round-trip bit for bit. Throws std::invalid_argument
/// for a node that is not finite, or a panel name that is empty or has blanks.
std::string format_stl(const Mesh& mesh);

}  // namespace mesh
