// SPDX-License-Identifier: Apache-2.0
// Gmsh files, versions 2.2 and 4.1: surface elements, physical groups as panels.
#pragma once

#include <string>
#include <string_view>

#include "mesh/mesh_file.hpp"

namespace mesh {

/// Reads a Gmsh file (MSH 2.2 or 4.1, ASCII or binary); lengths are not converted. `name` is the file's name
/// in messages.
/// - Triangles and quads of first order are elements. Points and lines are skipped.
/// - A panel is the physical group of an element's surface: its name (blanks and # become _), or
///   "physical_<number>". Elements in no group have "surface_<number>".
/// - Nodes that no element uses are left out.
///
/// Throws MeshFileError, with line and column or byte, for other versions, elements of volumes or of higher
/// order, node numbers that are repeated or do not exist, a surface in two groups (elements twice, in
/// version 2), counts that disagree, and numbers that are not finite.
Mesh parse_gmsh(std::string_view text, const std::string& name);

}  // namespace mesh
