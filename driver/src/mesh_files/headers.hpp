// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "mesh_files/soup.hpp"

namespace driver {

/// Checks what the header of a file announces: CGAL's readers believe it. They reserve what it counts, leave
/// out what it does not name, and read on at the wrong place behind what they do not know. Throws
/// membrane::MeshFileError, with the line of a text.
void check_header(const std::filesystem::path& path, SoupFormat format, const std::string& bytes);

}  // namespace driver
