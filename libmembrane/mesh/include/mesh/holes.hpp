// SPDX-License-Identifier: Apache-2.0
// Holes of a surface, and caps that close them.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "mesh/fill.hpp"
#include "mesh/mesh.hpp"

namespace mesh {

/// Least LoopPlane::roundness() of a hole that is closed: mouths of modules and vents have 0.8 and more, the
/// slits of seams whose sides parted 0.02 to 0.03.
inline constexpr double kLeastRoundness = 0.1;

/// A closed line of edges that only one element has.
struct Hole {
  std::vector<int> nodes;  // from 0, in the order in which the elements of a cap run
  int element;             // one of the elements beside it
  LoopPlane plane;         // its length, area and place
};

/// The holes of a surface, the longest first; equal ones in the order of their first nodes. Throws
/// std::invalid_argument, naming a node, if holes meet in it or the elements beside it run in different
/// directions, and for a node number out of range. With `lines` (Mesh::line), nodes count from 1.
std::vector<Hole> find_holes(const Eigen::Ref<const Eigen::Matrix3Xd>& nodes,
                             const Eigen::Ref<const Eigen::Matrix3Xi>& elements,
                             const std::vector<int>& lines = {});

/// "12 nodes, 0.314 m long, 0.00785 m2 around (0, 0, 0.1) m, 0 m off its plane".
std::string describe(const Hole& hole);

/// Closes a hole of the mesh with elements of its nodes, by fill(), in a panel of this name, new or not.
/// Mesh::line gives them the line of Hole::element. Throws std::invalid_argument, with describe(), if the
/// hole is longer than `longest` [m], is a slit by kLeastRoundness, or fill() refuses it.
void close_hole(Mesh& mesh, const Hole& hole, const std::string& panel, double longest);

}  // namespace mesh
