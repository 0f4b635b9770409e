// SPDX-License-Identifier: Apache-2.0
#include "mesh/turn_outward.hpp"

#include <Eigen/Geometry>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "edges.hpp"

namespace mesh {
namespace {

struct Neighbour {
  int element;
  bool same_way;  // it passes the common edge in the same direction
};

std::vector<std::vector<Neighbour>> neighbours_of(const Mesh& mesh) {
  std::vector<std::vector<Neighbour>> neighbours(static_cast<std::size_t>(mesh.element_count()));
  const std::vector<HalfEdge> edges = sorted_edges(mesh.elements);
  for (const EdgeGroup& group : edge_groups(edges)) {
    if (group.size() != 2) continue;
    const HalfEdge &a = group[0], &b = group[1];
    const bool same_way = a.forward == b.forward;
    neighbours[static_cast<std::size_t>(a.element)].push_back({b.element, same_way});
    neighbours[static_cast<std::size_t>(b.element)].push_back({a.element, same_way});
  }
  return neighbours;
}

void turn(Mesh& mesh, int element) {
  std::swap(mesh.elements(1, element), mesh.elements(2, element));
}

/// True if the volume between the elements of a part and its centre is below 0, by more than rounding.
bool is_inward(const Mesh& mesh, const std::vector<int>& part) {
  const Eigen::Matrix3Xd& nodes = mesh.start_nodes();
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const int e : part)
    for (const int node : mesh.elements.col(e)) centre += nodes.col(node);
  centre /= 3.0 * static_cast<double>(part.size());
  double volume = 0.0, area = 0.0;
  for (const int e : part) {
    const auto corner = [&](int i) -> Eigen::Vector3d { return nodes.col(mesh.elements(i, e)) - centre; };
    volume += corner(0).dot(corner(1).cross(corner(2))) / 6.0;
    area += 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
  }
  return volume < 0.0 && !is_flat(volume, area);
}

/// The elements connected to `first` by edges, itself included, turned to its winding.
std::vector<int> wind_part(Mesh& mesh, const std::vector<std::vector<Neighbour>>& neighbours, int first,
                           std::vector<bool>& seen) {
  std::vector<std::pair<int, bool>> part{{first, false}};  // elements, and whether each must be turned
  seen[static_cast<std::size_t>(first)] = true;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const auto [element, turned] = part[i];
    for (const Neighbour& next : neighbours[static_cast<std::size_t>(element)]) {
      if (seen[static_cast<std::size_t>(next.element)]) continue;
      seen[static_cast<std::size_t>(next.element)] = true;
      part.emplace_back(next.element, turned != next.same_way);
    }
  }
  std::vector<int> elements;
  for (const auto& [element, turned] : part) {
    if (turned) turn(mesh, element);
    elements.push_back(element);
  }
  return elements;
}

}  // namespace

int turn_outward(Mesh& mesh) {
  if (mesh.element_count() == 0) return 0;
  if (mesh.elements.minCoeff() < 0 || mesh.elements.maxCoeff() >= mesh.node_count())
    throw std::invalid_argument("turn_outward: an element has a node number out of range");
  const Eigen::Matrix3Xi before = mesh.elements;
  const auto neighbours = neighbours_of(mesh);
  std::vector<bool> seen(neighbours.size(), false);
  for (int first = 0; first < mesh.element_count(); ++first) {
    if (seen[static_cast<std::size_t>(first)]) continue;
    const std::vector<int> part = wind_part(mesh, neighbours, first, seen);
    if (is_inward(mesh, part))
      for (const int element : part) turn(mesh, element);
  }
  return static_cast<int>((mesh.elements.row(1).array() != before.row(1).array()).count());
}

}  // namespace mesh
