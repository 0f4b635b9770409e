// SPDX-License-Identifier: Apache-2.0
#include "skin_parts.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <string>
#include <tuple>

#include "check.hpp"

namespace coupling::detail {
namespace {

using Eigen::Vector3d;

void require_parameters(const SkinContactParameters& parameters) {
  require_positive("self_contact.thickness", parameters.thickness);
  require_positive("self_contact.stiffness", parameters.stiffness);
  require_not_negative("self_contact.friction", parameters.friction);
}

// Throws unless the thickness is below all altitudes.
double area_of(const Triangles& triangles, const Nodes& reference, Eigen::Index e, double thickness) {
  const Vector3d a = reference.col(triangles(0, e)), b = reference.col(triangles(1, e)),
                 c = reference.col(triangles(2, e));
  const double area = 0.5 * (b - a).cross(c - a).norm();
  require_positive("self_contact: area of element " + std::to_string(e), area);
  const double altitude = 2.0 * area / std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  if (thickness > altitude)
    reject("self_contact.thickness", text(thickness, 3) + " m",
           "at most the smallest altitude of an element: " + text(altitude, 3) + " m of element " +
               std::to_string(e));
  return area;
}

struct Corner {
  std::array<int, 2> edge;
  int triangle, corner;
};

std::vector<Corner> corners_by_edge(const Eigen::Matrix3Xi& triangles) {
  std::vector<Corner> corners;
  for (int e = 0; e < triangles.cols(); ++e)
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(triangles((k + 1) % 3, e), triangles((k + 2) % 3, e));
      corners.push_back({{low, high}, e, k});
    }
  std::ranges::sort(corners, [](const Corner& x, const Corner& y) {
    return std::tie(x.edge, x.triangle) < std::tie(y.edge, y.triangle);
  });
  return corners;
}

void find_edges(SkinParts& parts) {
  parts.triangle_edges.resize(3, parts.triangles.cols());
  const auto corners = corners_by_edge(parts.triangles);
  for (std::size_t i = 0; i < corners.size();) {
    std::vector<int> opposite;
    const std::size_t begin = i;
    for (; i < corners.size() && corners[i].edge == corners[begin].edge; ++i) {
      opposite.push_back(parts.triangles(corners[i].corner, corners[i].triangle));
      parts.triangle_edges(corners[i].corner, corners[i].triangle) = static_cast<int>(parts.edges.size());
    }
    parts.edges.push_back(corners[begin].edge);
    parts.shared_edges.push_back({corners[begin].triangle, 1 - static_cast<int>(opposite.size())});
    parts.opposite.add(opposite);
  }
}

void find_neighbours(SkinParts& parts, std::size_t node_count) {
  std::vector<std::vector<int>> joined(node_count);
  for (const auto& [a, b] : parts.edges) {
    joined[static_cast<std::size_t>(a)].push_back(b);
    joined[static_cast<std::size_t>(b)].push_back(a);
  }
  for (auto& list : joined) {
    std::ranges::sort(list);
    parts.neighbours_of.add(list);
  }
}

void count_nodes(SkinParts& parts, std::size_t node_count) {
  parts.shared_nodes.resize(node_count);
  for (int e = 0; e < parts.triangles.cols(); ++e)
    for (const int node : parts.triangles.col(e)) {
      const auto n = static_cast<std::size_t>(node);
      if (parts.shared_nodes[n].owner < 0) parts.shared_nodes[n].owner = e;
      --parts.shared_nodes[n].count;
    }
  for (std::size_t e = 0; e < parts.edges.size(); ++e)
    for (const int node : parts.edges[e])
      parts.shared_nodes[static_cast<std::size_t>(node)].count -= parts.shared_edges[e].count;
}

// Gives each node and edge to the group of its first element.
void share_out(SkinParts& parts) {
  const auto groups = parts.groups.count();
  std::vector<int> group_of(parts.groups.elements.size());
  for (std::size_t k = 0; k < parts.groups.elements.size(); ++k)
    group_of[static_cast<std::size_t>(parts.groups.elements[k])] = static_cast<int>(k / ElementGroups::kSize);
  const auto lists_of = [&](const std::vector<SharedPart>& shared) {
    std::vector<std::vector<int>> list(groups);
    for (std::size_t i = 0; i < shared.size(); ++i)
      if (const int owner = shared[i].owner; owner >= 0)
        list[static_cast<std::size_t>(group_of[static_cast<std::size_t>(owner)])].push_back(
            static_cast<int>(i));
    Lists lists;
    for (const auto& l : list) lists.add(l);
    return lists;
  };
  parts.group_nodes = lists_of(parts.shared_nodes);
  parts.group_edges = lists_of(parts.shared_edges);
}

void weigh(SkinParts& parts, const Nodes& reference) {
  parts.node_weight.assign(parts.masses.size(), 0.0);
  parts.edge_weight.assign(parts.edges.size(), 0.0);
  for (Eigen::Index e = 0; e < parts.triangles.cols(); ++e) {
    const double area = area_of(parts.triangles, reference, e, parts.parameters.thickness);
    for (int k = 0; k < 3; ++k) {
      parts.node_weight[static_cast<std::size_t>(parts.triangles(k, e))] += area / 6.0;
      parts.edge_weight[static_cast<std::size_t>(parts.triangle_edges(k, e))] += area / 2.0;
    }
  }
  for (const auto& [a, b] : parts.edges) parts.mean_edge += (reference.col(a) - reference.col(b)).norm();
  parts.mean_edge /= static_cast<double>(parts.edges.size());
  double largest = 0.0;
  for (std::size_t n = 0; n < parts.masses.size(); ++n)
    largest = std::max(largest, parts.node_weight[n] / parts.masses[n]);
  parts.full_omega_squared = 8.0 * parts.parameters.stiffness * largest;
}

}  // namespace

SkinParts::SkinParts(const Triangles& given, const Nodes& reference, std::span<const double> given_masses,
                     const SkinContactParameters& given_parameters)
    : parameters(given_parameters), triangles(given), masses(given_masses.begin(), given_masses.end()) {
  require_parameters(parameters);
  require_nodes("self_contact.triangles", triangles, reference.cols());
  if (triangles.cols() == 0) reject("self_contact.triangles", "none", "at least one");
  if (masses.size() != static_cast<std::size_t>(reference.cols()))
    reject("self_contact.masses", std::to_string(masses.size()) + " values", "one value a node");
  for (std::size_t a = 0; a < masses.size(); ++a)
    require_positive("self_contact.masses[" + std::to_string(a) + "]", masses[a]);
  find_edges(*this);
  find_neighbours(*this, masses.size());
  count_nodes(*this, masses.size());
  weigh(*this, reference);
  groups = make_groups(triangles, reference);
  share_out(*this);
  masks = PartMasks(*this);
}

bool SkinParts::adjacent(int node, int other) const {
  return node == other || std::ranges::binary_search(neighbours_of[node], other);
}

bool SkinParts::neighbours(const PartPair& pair) const {
  if (!pair.edges) {
    const auto corner = triangles.col(pair.second);
    return adjacent(pair.first, corner[0]) || adjacent(pair.first, corner[1]) ||
           adjacent(pair.first, corner[2]);
  }
  const auto [a, b] = edges[static_cast<std::size_t>(pair.first)];
  const auto [c, d] = edges[static_cast<std::size_t>(pair.second)];
  return adjacent(a, c) || adjacent(a, d) || adjacent(b, c) || adjacent(b, d);
}

int SkinParts::count_of_edge(int edge, int node) const {
  int count = shared_edges[static_cast<std::size_t>(edge)].count;
  for (const int other : opposite[edge]) count += adjacent(node, other);
  return count;
}

int SkinParts::count_of_node(int corner, int node) const {
  for (const int other : neighbours_of[corner])
    if (adjacent(node, other)) return 0;
  return shared_nodes[static_cast<std::size_t>(corner)].count;
}

}  // namespace coupling::detail
