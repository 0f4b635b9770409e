// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "soup.hpp"

namespace driver {

/// Checks the header of a file against its contents, because CGAL's readers trust the header: they reserve as
/// many elements as it counts, skip elements that it does not name, and lose their place after an unknown
/// property. Throws mesh::MeshFileError, with the line if the file is text. Returns the counting lines of a
/// PLY header, "element vertex 8, element face 12".
std::string check_header(const std::filesystem::path& path, SoupFormat format, const std::string& bytes);

}  // namespace driver
