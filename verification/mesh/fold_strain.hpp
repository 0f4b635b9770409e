// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "mesh/fold.hpp"

namespace fold_strain {

// Largest tensile strain against the stress-free shape, of a length.
inline double largest_strain(const mesh::Mesh& mesh, const mesh::Folding& folding, bool outside_of_bends) {
  const auto stretches = mesh::principal_stretches(mesh.nodes, folding.nodes(), mesh.elements);
  double largest = 0.0;
  for (int e = 0; e < mesh.element_count(); ++e) {
    const Eigen::Vector3i corners = mesh.elements.col(e);
    const bool bent = std::any_of(corners.begin(), corners.end(), [&](int node) {
      return bool{folding.gathered()[static_cast<std::size_t>(node)]};
    });
    if (!bent || !outside_of_bends)
      largest = std::max(largest, stretches[static_cast<std::size_t>(e)][1] - 1.0);
  }
  return largest;
}

}  // namespace fold_strain
