// SPDX-License-Identifier: Apache-2.0
// Radioss starter decks: /NODE, /SHELL, /SH3N and the titles of /PART as panels.
#pragma once

#include <string>
#include <string_view>

#include "mesh/mesh_file.hpp"

namespace mesh {

/// Reads a starter deck; lengths are not converted; units in /BEGIN are ignored. `name` is the file's name in
/// messages. The text begins with /BEGIN and ends with /END; without /END it is refused as truncated. Lines
/// that begin with `#` or `$` are comments, except `#include NAME`, which `included` reads.
///
/// Cards are in columns, 10 for a number and 20 for a coordinate:
/// - /NODE: number, x, y, z;
/// - /SHELL/part: number, n1 to n4; a triangle if n4 is blank, 0 or n3; quads are split along their shorter
///   diagonal;
/// - /SH3N/part: number, n1 to n3;
/// - /PART/number: a title line;
/// - /XREF/part: a title, Nitrs, then cards like those of /NODE with the stress-free shape, Mesh::nodes;
///   Mesh::start then has the positions of /NODE;
/// - /REFSTA: the name of a file with such cards, by default the run's name and RS0; then Nitrs and the
///   file's format, 1 for columns of 8 and 16;
/// - /EREF/SHELL/part, /EREF/SH3N/part: a title, then shells with the nodes at which their corners are.
///
/// A deck for both programs begins with the engine's part, up to /END/ENGINE, which is not read.
///
/// Panels are the parts as in keyword.hpp. Nodes that no shell uses are left out; other blocks are skipped
/// and listed (Mesh::other_elements, Mesh::skipped; Mesh::neglected as in keyword.hpp).
///
/// Throws MeshFileError, with line and column, for numbers of nodes, elements and parts that are not above 0
/// or are repeated, nodes that do not exist, and coordinates that are blank or not finite.
Mesh parse_radioss(std::string_view text, const std::string& name, const IncludedFile& included = {});

}  // namespace mesh
