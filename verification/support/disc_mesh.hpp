// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <vector>

#include "mesh/mesh.hpp"

namespace scenes {

inline mesh::Mesh plain_mesh(const Eigen::Matrix3Xd& nodes, const std::vector<Eigen::Vector3i>& elements) {
  mesh::Mesh mesh;
  mesh.nodes = nodes;
  mesh.elements.resize(3, static_cast<Eigen::Index>(elements.size()));
  for (std::size_t e = 0; e < elements.size(); ++e)
    mesh.elements.col(static_cast<Eigen::Index>(e)) = elements[e];
  mesh.panel.assign(elements.size(), 0);
  mesh.panel_names = {"skin"};
  return mesh;
}

// Node j of ring k, j taken round the ring.
inline int ring_node(int k, int j) {
  return k == 0 ? 0 : 3 * k * (k - 1) + 1 + j % (6 * k);
}

// Plane disc in z = 0, normal +z: ring k of `rings` has 6 k nodes, 6 rings^2 elements, the rim's nodes last.
inline mesh::Mesh disc(double radius, int rings) {
  Eigen::Matrix3Xd nodes = Eigen::Matrix3Xd::Zero(3, 3 * rings * (rings + 1) + 1);
  std::vector<Eigen::Vector3i> elements;
  for (int k = 1; k <= rings; ++k)
    for (int j = 0; j < 6 * k; ++j) {
      const double angle = std::numbers::pi * j / (3.0 * k), r = radius * k / rings;
      nodes.col(ring_node(k, j)) << r * std::cos(angle), r * std::sin(angle), 0.0;
      const int sextant = j / k, inner = j - sextant;  // inner ring's node at or before this one
      elements.emplace_back(ring_node(k - 1, inner), ring_node(k, j), ring_node(k, j + 1));
      if (j % k != k - 1)
        elements.emplace_back(ring_node(k - 1, inner), ring_node(k, j + 1), ring_node(k - 1, inner + 1));
    }
  return plain_mesh(nodes, elements);
}

}  // namespace scenes
