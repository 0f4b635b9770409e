// SPDX-License-Identifier: Apache-2.0
// A mesh from nodes and polygons, for readers of other programs' formats.
#pragma once

#include <vector>

#include "mesh/mesh.hpp"

namespace mesh {

/// Mesh of polygons with 3 corners or more, node numbers from 0, in one panel "default". Quads are split
/// along the shorter diagonal, or along the longer one if the shorter is already a side of a polygon or of a
/// half of another quad (nodes at one position count as one); polygons of more corners by fill(). Nodes that
/// no polygon uses are left out. Throws std::invalid_argument, naming the polygon by its number from 0, for
/// fewer corners, one that fill() refuses, a node that is out of range, and a node that is not finite; also
/// if there is no polygon.
Mesh mesh_of_polygons(const Eigen::Matrix3Xd& nodes, const std::vector<std::vector<int>>& polygons);

}  // namespace mesh
