// SPDX-License-Identifier: Apache-2.0
// Holes of a bag's mesh, closed by null panels on request.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace driver {

/// [m] Longest hole that is closed unless a case or command says otherwise: longer than vents and mouths of
/// modules, shorter than an open seam.
inline constexpr double longest_hole = 1.5;

/// A null panel to be, and the hole that it closes.
struct Cap {
  std::string panel;
  std::optional<int> hole;  // from 1, the longest first; all holes if there is none
};

/// A line for each hole, "hole 1: 12 nodes, ...", the longest first, or one that says why there is no list.
/// Empty if the surface has no hole.
std::string list_of_holes(const mesh::Mesh& mesh);

/// Closes holes by mesh::close_hole. Returns a line for each, "panel vent closes hole 1: ...". Throws
/// std::invalid_argument for a hole that does not exist or was closed before, a panel of the mesh's own, and
/// as mesh::close_hole.
std::vector<std::string> close_holes(mesh::Mesh& mesh, const std::vector<Cap>& caps, double longest);

}  // namespace driver
