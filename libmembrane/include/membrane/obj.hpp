// SPDX-License-Identifier: Apache-2.0
// Wavefront OBJ text: nodes (v), elements (f) and panels (g, o).
#pragma once

#include <string>
#include <string_view>

#include "membrane/mesh_file.hpp"

namespace membrane {

/// Reads OBJ text, lengths in metres; `name` stands for the file in messages. Statements: `v x y z [w]` (w
/// ignored); `f` with 3 or 4 corners written i, i/j, i//k or i/j/k, the index counted from 1 or, negative,
/// back from the last node (quads are split along the shorter diagonal); `g`/`o` name (elements that follow
/// belong to that panel; "default" before the first); `#` comments; vt, vn, vp, s, usemtl, mtllib are
/// skipped. Anything else, a number that is not finite, an index without a node above it or a repeated corner
/// throws MeshFileError with line and column. Closedness is not asked here: surface_check.hpp.
Mesh parse_obj(std::string_view text, const std::string& name);

/// OBJ text of a mesh, elements grouped by panel as they come; nodes round-trip bit for bit. Throws
/// std::invalid_argument if a panel name is empty or has white space, or a node is not finite.
std::string format_obj(const Mesh& mesh);

}  // namespace membrane
