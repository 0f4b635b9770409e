// SPDX-License-Identifier: Apache-2.0
#include "mesh/holes.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "checks.hpp"
#include "edges.hpp"

namespace mesh {
namespace {

struct NextNode {
  int node, element;
};

std::string node_name(int node, const std::vector<int>& lines) {
  return "node " + std::to_string(lines.empty() ? node : node + 1);
}

// From each node of an open edge to the next one, as a cap runs: against the element beside it.
std::map<int, NextNode> next_nodes(const std::vector<HalfEdge>& edges, const std::vector<int>& lines) {
  std::map<int, NextNode> next;
  for (const EdgeGroup& group : edge_groups(edges)) {
    if (group.size() != 1) continue;
    const HalfEdge& edge = group.front();
    const int from = edge.forward ? edge.high : edge.low, to = edge.forward ? edge.low : edge.high;
    if (!next.try_emplace(from, NextNode{to, edge.element}).second)
      throw std::invalid_argument(
          "a hole cannot be followed at " + node_name(from, lines) +
          ": holes meet there, or the elements beside it run in different directions");
  }
  return next;
}

Hole hole_from(int first, std::map<int, NextNode>& next, const Eigen::Ref<const Eigen::Matrix3Xd>& nodes,
               const std::vector<int>& lines) {
  Hole hole{{}, next.at(first).element, {}};
  for (int node = first;;) {
    const auto found = next.find(node);
    if (found == next.end())
      throw std::invalid_argument("a hole ends at " + node_name(node, lines) +
                                  ": the elements beside it run in different directions");
    hole.nodes.push_back(node);
    node = found->second.node;
    next.erase(found);
    if (node == first) break;
  }
  hole.plane = loop_plane(nodes(Eigen::all, hole.nodes));
  return hole;
}

int panel_of(Mesh& mesh, const std::string& name) {
  const auto found = std::ranges::find(mesh.panel_names, name);
  if (found == mesh.panel_names.end()) {
    mesh.panel_names.push_back(name);
    return static_cast<int>(mesh.panel_names.size()) - 1;
  }
  return static_cast<int>(found - mesh.panel_names.begin());
}

}  // namespace

std::vector<Hole> find_holes(const Eigen::Ref<const Eigen::Matrix3Xd>& nodes,
                             const Eigen::Ref<const Eigen::Matrix3Xi>& elements,
                             const std::vector<int>& lines) {
  require_nodes("find_holes", elements, nodes.cols());
  const std::vector<HalfEdge> edges = sorted_edges(elements);
  std::map<int, NextNode> next = next_nodes(edges, lines);
  std::vector<Hole> holes;
  while (!next.empty()) holes.push_back(hole_from(next.begin()->first, next, nodes, lines));
  std::ranges::stable_sort(holes, std::greater<>{}, [](const Hole& hole) { return hole.plane.length; });
  return holes;
}

std::string describe(const Hole& hole) {
  const LoopPlane& plane = hole.plane;
  const Eigen::Vector3d at = (plane.centre.array().abs() < 1e-9 * plane.length).select(0.0, plane.centre);
  std::array<char, 200> text;
  std::snprintf(text.data(), text.size(),
                "%zu nodes, %.3g m long, %.3g m2 around (%.3g, %.3g, %.3g) m, %.2g m off its plane",
                hole.nodes.size(), plane.length, plane.area, at.x(), at.y(), at.z(), plane.off_plane);
  return text.data();
}

void close_hole(Mesh& mesh, const Hole& hole, const std::string& panel, double longest) {
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument("the hole of " + describe(hole) + " " + why);
  };
  if (hole.plane.length > longest)
    refuse("is longer than " + three_digits(longest) + " m, the longest to be closed");
  if (const double roundness = hole.plane.roundness(); roundness < kLeastRoundness)
    refuse("is rather a seam whose sides parted: its area is " + three_digits(roundness) +
           " times that of a circle of its length, allowed: at least " + three_digits(kLeastRoundness) +
           "; join the sides by gasjet mesh convert --merge DISTANCE");
  const std::set<int> own(hole.nodes.begin(), hole.nodes.end());
  std::set<std::pair<int, int>> taken;
  for (const HalfEdge& edge : sorted_edges(mesh.elements))
    if (own.contains(edge.low) && own.contains(edge.high)) taken.emplace(edge.low, edge.high);
  const auto node = [&](int i) { return hole.nodes[static_cast<std::size_t>(i)]; };
  const Filling filling = fill(mesh.nodes(Eigen::all, hole.nodes),
                               [&](int i, int j) { return taken.contains(std::minmax(node(i), node(j))); });
  if (!filling.fault.empty()) refuse(filling.fault);
  const Eigen::Index before = mesh.elements.cols();
  mesh.elements.conservativeResize(3, before + static_cast<Eigen::Index>(filling.triangles.size()));
  const int index = panel_of(mesh, panel);
  for (std::size_t i = 0; i < filling.triangles.size(); ++i) {
    const auto& [a, b, c] = filling.triangles[i];
    mesh.elements.col(before + static_cast<Eigen::Index>(i)) << node(a), node(b), node(c);
    mesh.panel.push_back(index);
    if (!mesh.line.empty()) mesh.line.push_back(mesh.line[static_cast<std::size_t>(hole.element)]);
  }
}

}  // namespace mesh
