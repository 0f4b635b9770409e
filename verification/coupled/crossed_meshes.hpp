// SPDX-License-Identifier: Apache-2.0
// Surfaces that pass through themselves.
#pragma once

#include <Eigen/Core>

#include "mesh/mesh.hpp"

namespace crossed {

// Two meshes as one, the second moved.
inline mesh::Mesh together(const mesh::Mesh& one, const mesh::Mesh& other, const Eigen::Vector3d& move) {
  mesh::Mesh both;
  both.nodes.resize(3, one.nodes.cols() + other.nodes.cols());
  both.nodes << one.nodes, other.nodes.colwise() + move;
  both.elements.resize(3, one.elements.cols() + other.elements.cols());
  both.elements << one.elements, (other.elements.array() + one.node_count()).matrix();
  return both;
}

// The unit cube of twelve triangles, outward.
inline mesh::Mesh cube() {
  mesh::Mesh mesh;
  mesh.nodes.resize(3, 8);
  for (int n = 0; n < 8; ++n) mesh.nodes.col(n) << n % 2, n / 2 % 2, n / 4;
  mesh.elements.resize(3, 12);
  mesh.elements << 0, 0, 4, 4, 0, 0, 2, 2, 0, 0, 1, 1,  //
      2, 3, 5, 7, 1, 5, 6, 7, 4, 6, 3, 7,               //
      3, 1, 7, 6, 5, 4, 7, 3, 6, 2, 7, 5;
  return mesh;
}

}  // namespace crossed
