// SPDX-License-Identifier: Apache-2.0
// Mesh files of every format: those of libmembrane, and PLY and binary STL through CGAL's readers of
// polygon soups. CGAL stays inside this library.
#pragma once

#include <filesystem>

#include "mesh/mesh_file.hpp"

namespace driver {

/// The endings of readable formats, for help and messages.
inline constexpr const char* mesh_endings =
    ".obj, .k, .key, .dyn, .rad, .stl, .ply, .off, .vtk, .vtu, .vtp, .msh";

/// Reads a mesh in the format of the file's ending; lengths are not converted. Throws mesh::MeshFileError for
/// another
/// ending, a file that cannot be read, and whatever is wrong with its text. Files that CGAL reads have no
/// Mesh::line, and one panel, "default".
mesh::Mesh read_any_mesh(const std::filesystem::path& path);

}  // namespace driver
