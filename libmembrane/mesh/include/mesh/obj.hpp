// SPDX-License-Identifier: Apache-2.0
// Wavefront OBJ text: nodes (v), elements (f) and panels (g, o).
#pragma once

#include <string>
#include <string_view>

#include "mesh/mesh_file.hpp"

namespace mesh {

/// Reads OBJ text, lengths in metres. `name` is the file's name in messages. Statements:
/// - `v x y z [w]`: a node; w is ignored.
/// - `f` with 3 corners or more, each written i, i/j, i//k or i/j/k. The index counts from 1 or, if negative,
///   back from the last node. Polygons are split as by mesh_of_polygons.
/// - `g name`, `o name`: the elements that follow belong to this panel; before the first one, to "default".
/// - `\` at the end of a line: the statement goes on in the next one.
/// - `#`: a comment. vt, vn, vp, s, usemtl and mtllib are skipped.
///
/// Throws MeshFileError, with line and column, for anything else, a number that is not finite, and an index
/// without a node above it. surface_check.hpp checks whether the surface is closed.
Mesh parse_obj(std::string_view text, const std::string& name);

/// OBJ text of a mesh. Elements keep their order, with a panel line at each change of panel; nodes round-trip
/// bit for bit. Throws std::invalid_argument if a panel name is empty or has white space, or a node is not
/// finite.
std::string format_obj(const Mesh& mesh);

}  // namespace mesh
