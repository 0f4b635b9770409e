// SPDX-License-Identifier: Apache-2.0
// Private to the readers of VTK files: what a file of any of their kinds has, and the mesh of it.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace mesh {

/// A cell of a VTK file.
struct VtkCell {
  static constexpr int polygon = 7, strip = 6, line = 3;
  std::vector<long long> nodes;
  int type;                                 // of VTK
  std::size_t line_number = 0, column = 0;  // of its place; 0: the file has no lines
};

/// A whole number for each cell.
struct VtkArray {
  std::string name;
  std::vector<long long> values;
};

struct VtkGrid {
  std::string file;  // its name in messages
  std::vector<Eigen::Vector3d> points;
  std::vector<VtkCell> cells;    // in the order of the arrays' values; nodes are in range
  std::vector<VtkArray> arrays;  // with one value for each cell
};

/// The cells with an area, and as panels the values of an array. Throws MeshFileError.
Mesh mesh_of_grid(const VtkGrid& grid);

}  // namespace mesh
