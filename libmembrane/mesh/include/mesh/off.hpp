// SPDX-License-Identifier: Apache-2.0
// OFF text: nodes and polygons.
#pragma once

#include <string>
#include <string_view>

#include "mesh/mesh_file.hpp"

namespace mesh {

/// Reads OFF text (also COFF, NOFF, STOFF); lengths are not converted. `name` is the file's name in messages.
/// Elements are faces of 3 corners or more, split as by mesh_of_polygons, in one panel "default". `#`
/// begins a comment. Nodes that no face uses are left out.
/// - Usually each vertex or face has its own line. Normals and colours after its coordinates or corners are
///   not read.
/// - If that fails, the file is read word by word, with any line ends; it then has no colours.
///
/// Throws MeshFileError, with line and column, for binary files, other dimensions, node numbers out of range,
/// numbers that are not finite, and more or fewer items than the header announces.
Mesh parse_off(std::string_view text, const std::string& name);

}  // namespace mesh
