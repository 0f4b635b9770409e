// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "soup.hpp"

namespace driver {

/// Checks the header of a file against its contents, because CGAL's readers believe the header. They reserve
/// as many elements as it counts. They skip what it does not name. After a property that they do not know
/// they read at the wrong place. Throws mesh::MeshFileError, with the line if the file is text. Returns
/// the lines of a PLY header that count elements, "element vertex 8, element face 12".
std::string check_header(const std::filesystem::path& path, SoupFormat format, const std::string& bytes);

}  // namespace driver
