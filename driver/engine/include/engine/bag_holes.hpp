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
  std::string set = {};     // instead, the holes whose nodes are all in this node set of the file
};

/// Caps that close all holes: each has the name of the smallest node set with all nodes of the hole or, if
/// there is none, it has another hole too or the name is in use, "cap_" and its number. Throws
/// std::invalid_argument if there is no hole.
std::vector<Cap> caps_of_all(const mesh::Mesh& mesh);

/// A line for each of the twenty longest holes, "hole 1: 12 nodes, ...", with their node sets, or one that
/// says why there is no list. Empty if the surface has no hole.
std::string list_of_holes(const mesh::Mesh& mesh);

/// Closes holes by mesh::close_hole. Returns a line for each, "panel vent closes hole 1: ...". Throws
/// std::invalid_argument for a hole or set that does not exist or was closed before, a cap without a hole, a
/// panel of the mesh's own, and as mesh::close_hole.
std::vector<std::string> close_holes(mesh::Mesh& mesh, const std::vector<Cap>& caps, double longest);

}  // namespace driver
