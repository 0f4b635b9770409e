// SPDX-License-Identifier: Apache-2.0
// Private to the mesh files: reading and writing of text and numbers.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "mesh/mesh.hpp"

namespace mesh {

/// The text in quotes, shortened and printable, for messages.
std::string shown(std::string_view text);

/// Reads a finite number; a leading + is allowed. Returns its fault; empty if there is none.
std::string number_fault(std::string_view text, double& value);

/// Appends the shortest text that reads back to the same bits.
void append_number(double value, std::string& text);

std::string read_text(const std::filesystem::path& path);                     // throws MeshFileError
void write_text(const std::filesystem::path& path, const std::string& text);  // throws MeshFileError

/// A panel's name from a file: blanks and # become _; "default" if there is none.
std::string panel_name(std::string_view text);

/// Throws std::invalid_argument unless all nodes are finite.
void require_finite_nodes(const Mesh& mesh);

}  // namespace mesh
