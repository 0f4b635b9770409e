// SPDX-License-Identifier: Apache-2.0
// LS-DYNA keyword text: *NODE, *ELEMENT_SHELL and the titles of *PART as panels.
#pragma once

#include <string>
#include <string_view>

#include "mesh/mesh_file.hpp"

namespace mesh {

/// Reads keyword text; lengths are not converted. `name` is the file's name in messages. The text begins with
/// *KEYWORD (long format by LONG=Y), *KEYWORD_ID or *KEYWORD_JOBID, and ends with *END; without *END it is
/// refused as truncated. Lines that begin with `$` are comments.
///
/// Cards are comma separated or in columns:
/// - *NODE: id (8), x, y, z (16 each);
/// - *ELEMENT_SHELL: id, part, n1 to n4 (8 each); the card that _THICKNESS, _BETA, _MCID or _OFFSET adds is
///   skipped, but must exist;
/// - *INCLUDE: the name of a file, which `included` reads; ` +` at a line's end continues the name in the
///   next line; an *END in the file ends that file only;
/// - *AIRBAG_REFERENCE_GEOMETRY, also with _ID, _BIRTH and _RDT: with _ID a card of scales and the node they
///   are about (10 each), with _BIRTH a card with a time, then cards like those of *NODE. They give the
///   stress-free shape, Mesh::nodes; Mesh::start then has the positions of *NODE;
/// - *AIRBAG_SHELL_REFERENCE_GEOMETRY: id, part, n1 to n4 (8 each), nodes at which the shell's corners are in
///   the stress-free shape;
/// - *PART: a title line, then the id (10); also with _INERTIA, _CONTACT, _REPOSITION, _PRINT or _COMPOSITE.
///
/// All fields have 20 columns in the long format or after *NODE+. A shell whose n4 is blank, 0 or n3 is a
/// triangle; a quad is split along its shorter diagonal. Panels are the parts in the order of their first
/// element. A panel has the part's title as its name (blanks and # become _, a repeated title gets _id), or
/// "part_id". Nodes that no shell uses are left out; other keywords are skipped
/// and listed (Mesh::other_elements, Mesh::skipped). Mesh::neglected has keywords that change the bag:
/// *PART_MOVE, stress, strain and velocity at the start, thicknesses and angles of single shells, and a
/// stress-free shape in which a node has two positions.
///
/// Throws MeshFileError, with line and column, for
/// - files that cannot be included, *INCLUDE_TRANSFORM, other columns and forms of *NODE, text after a
/// keyword, and 8-node shells,
/// - ids that are not above 0 or are repeated, and nodes that do not exist,
/// - numbers that are blank or not finite.
Mesh parse_keyword(std::string_view text, const std::string& name, const IncludedFile& included = {});

/// Keyword text of a mesh in the long format, comma separated, so that nodes round-trip bit for bit. Some
/// numbers have more than 20 characters; a program that cuts fields at 20 columns loses at most 1e-16 of the
/// value. Throws std::invalid_argument if a panel name is empty or has control characters, or a node is not
/// finite.
std::string format_keyword(const Mesh& mesh);

}  // namespace mesh
