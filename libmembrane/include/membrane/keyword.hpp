// SPDX-License-Identifier: Apache-2.0
// LS-DYNA keyword text: *NODE, *ELEMENT_SHELL and the titles of *PART as panels.
#pragma once

#include <string>
#include <string_view>

#include "membrane/mesh_file.hpp"

namespace membrane {

/// Reads a keyword file, lengths as they stand; `name` stands for the file in messages. It begins with
/// *KEYWORD (long format by LONG=Y) and ends with *END, without which it counts as truncated. `$` lines are
/// comments. Cards are comma separated or in columns: *NODE id (8), x, y, z (16 each); *ELEMENT_SHELL id,
/// part, n1 to n4 (8 each); *PART a title line and the id (10); 20 each in the long format or after *NODE+. A
/// shell whose n4 is blank, 0 or n3 is a triangle; quads are split along the shorter diagonal. Panels are the
/// parts in the order of their first element, named by the title (blanks and # as _, a repeated title with
/// _id) or "part_id". Nodes that no shell uses are left out; other keywords are skipped. *INCLUDE, other
/// elements, columns and forms of *NODE, text after a keyword, 8-node shells, ids that are not above 0 or
/// repeated, nodes that do not exist and numbers that are blank or not finite throw MeshFileError with line
/// and column.
Mesh parse_keyword(std::string_view text, const std::string& name);

/// Keyword text of a mesh: long format, comma separated, so that nodes round-trip bit for bit. (Numbers of
/// more than 20 characters occur; a program that cuts fields at 20 columns loses their last digits, 1e-16 of
/// the value at most.) Throws std::invalid_argument if a panel name is empty or has control characters, or a
/// node is not finite.
std::string format_keyword(const Mesh& mesh);

}  // namespace membrane
