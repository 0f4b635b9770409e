// SPDX-License-Identifier: Apache-2.0
#include "mesh/polygons.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "mesh/merge.hpp"
#include "mesh_builder.hpp"
#include "mesh_text.hpp"

namespace mesh {

Mesh mesh_of_polygons(const Eigen::Matrix3Xd& nodes, const std::vector<std::vector<int>>& polygons) {
  if (polygons.empty()) throw std::invalid_argument("the file has no elements");
  MeshBuilder mesh;
  for (Eigen::Index n = 0; n < nodes.cols(); ++n) {
    if (!nodes.col(n).allFinite())
      throw std::invalid_argument("node " + std::to_string(n) + ": a coordinate is not finite");
    mesh.add_node(nodes.col(n));
  }
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const std::vector<int>& corners = polygons[i];
    const std::string where = "element " + std::to_string(i) + ": ";
    if (corners.size() < 3)
      throw std::invalid_argument(where + std::to_string(corners.size()) + " corners, allowed: 3 or more");
    for (const int node : corners)
      if (node < 0 || node >= nodes.cols())
        throw std::invalid_argument(where + "node " + std::to_string(node) + " is out of range, 0 to " +
                                    std::to_string(nodes.cols() - 1));
    mesh.add_polygon(corners, "default", 0);
  }
  return used_nodes(std::move(mesh).finish());
}

}  // namespace mesh
