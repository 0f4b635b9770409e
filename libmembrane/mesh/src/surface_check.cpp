// SPDX-License-Identifier: Apache-2.0
#include "mesh/surface_check.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "checks.hpp"
#include "edges.hpp"
#include "mesh/mesh.hpp"

namespace mesh {
namespace {

constexpr std::size_t kNamed = 5;  // faults of each kind that describe() lists

struct Disjoint {  // union-find over 0..n-1, path halving; the root is the lowest member
  std::vector<int> parent;
  explicit Disjoint(int n) : parent(static_cast<std::size_t>(n)) {
    std::iota(parent.begin(), parent.end(), 0);
  }
  int root(int i) {
    auto at = [this](int k) -> int& { return parent[static_cast<std::size_t>(k)]; };
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  }
  void join(int i, int j) {
    const int a = root(i), b = root(j);
    parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }
};

using Elements = Eigen::Ref<const Eigen::Matrix3Xi>;
void check_indices(Eigen::Index node_count, const Elements& elements, SurfaceReport& report) {
  std::vector<bool> used(static_cast<std::size_t>(node_count), false);
  for (int e = 0; e < elements.cols(); ++e) {
    const Eigen::Vector3i n = elements.col(e);
    if (n.minCoeff() < 0 || n.maxCoeff() >= node_count) {
      report.out_of_range_elements.push_back(e);
      continue;
    }
    if (n(0) == n(1) || n(1) == n(2) || n(2) == n(0)) report.repeated_node_elements.push_back(e);
    for (int a = 0; a < 3; ++a) used[static_cast<std::size_t>(n(a))] = true;
  }
  for (std::size_t i = 0; i < used.size(); ++i)
    if (!used[i]) report.unused_nodes.push_back(static_cast<int>(i));
}

void check_edges(const std::vector<EdgeGroup>& groups, SurfaceReport& report) {
  for (const EdgeGroup& group : groups) {
    const HalfEdge& first = group.front();
    if (group.size() == 2 && group[0].forward != group[1].forward) continue;
    EdgeFault fault{first.forward ? std::array{first.low, first.high} : std::array{first.high, first.low},
                    {}};
    for (const HalfEdge& edge : group) fault.elements.push_back(edge.element);
    if (group.size() == 1) report.boundary_edges.push_back(fault);
    if (group.size() > 2) report.non_manifold_edges.push_back(fault);
    if (group.size() == 2) report.inconsistent_edges.push_back(fault);
  }
}

void check_components(const std::vector<EdgeGroup>& groups, int element_count, SurfaceReport& report) {
  Disjoint sets(element_count);
  for (const EdgeGroup& group : groups)
    for (const HalfEdge& edge : group) sets.join(group.front().element, edge.element);
  std::vector<int> component(static_cast<std::size_t>(element_count), -1);  // component of each root
  std::vector<std::vector<int>> components;
  for (int e = 0; e < element_count; ++e) {
    int& own = component[static_cast<std::size_t>(sets.root(e))];
    if (own < 0) {
      own = static_cast<int>(components.size());
      components.emplace_back();
    }
    components[static_cast<std::size_t>(own)].push_back(e);
  }
  if (components.size() > 1) report.components = std::move(components);
}

// The elements round a node form one fan if their corners at that node are joined across shared edges.
void check_fans(const std::vector<EdgeGroup>& groups, const Elements& elements, SurfaceReport& report) {
  Disjoint fans(static_cast<int>(3 * elements.cols()));
  const auto corner_at = [](const HalfEdge& edge, bool low) {
    return 3 * edge.element + (edge.forward == low ? edge.side : (edge.side + 1) % 3);
  };
  for (const EdgeGroup& group : groups)
    for (const HalfEdge& edge : group) {
      fans.join(corner_at(group.front(), true), corner_at(edge, true));
      fans.join(corner_at(group.front(), false), corner_at(edge, false));
    }
  std::vector<std::pair<int, int>> fan_of_node;
  for (int e = 0; e < elements.cols(); ++e)
    for (int a = 0; a < 3; ++a) fan_of_node.emplace_back(elements(a, e), fans.root(3 * e + a));
  std::sort(fan_of_node.begin(), fan_of_node.end());
  fan_of_node.erase(std::unique(fan_of_node.begin(), fan_of_node.end()), fan_of_node.end());
  for (std::size_t i = 1; i < fan_of_node.size(); ++i) {
    const int node = fan_of_node[i].first;
    const bool reported = !report.pinched_nodes.empty() && report.pinched_nodes.back() == node;
    if (fan_of_node[i - 1].first == node && !reported) report.pinched_nodes.push_back(node);
  }
}

void check_nodes_finite(const Eigen::Ref<const Eigen::Matrix3Xd>& nodes, SurfaceReport& report) {
  for (int i = 0; i < nodes.cols(); ++i)
    if (!nodes.col(i).allFinite()) report.non_finite_nodes.push_back(i);
}

// Names of nodes and elements: numbers from 0 or, in a mesh that was read, nodes from 1 and elements by their
// lines.
struct Names {
  const std::vector<int>& lines;
  std::string node(int i) const { return std::to_string(lines.empty() ? i : i + 1); }
  std::string element(int e) const {
    return std::to_string(lines.empty() ? e : lines[static_cast<std::size_t>(e)]);
  }
  std::string elements() const { return lines.empty() ? "elements" : "elements in lines"; }
};

template <class Name>
std::string list_of(const std::vector<int>& items, Name&& name) {
  std::string text;
  for (std::size_t i = 0; i < std::min(items.size(), kNamed); ++i) text += (i ? ", " : " ") + name(items[i]);
  return items.size() > kNamed ? text + ", ..." : text;
}

template <class Name>
void describe_list(const std::string& what, const std::vector<int>& items, Name&& name, std::string& text) {
  if (!items.empty()) text += std::to_string(items.size()) + " " + what + ":" + list_of(items, name) + "\n";
}

void describe_edges(const std::string& what, const std::vector<EdgeFault>& edges, const Names& names,
                    std::string& text) {
  if (edges.empty()) return;
  text += std::to_string(edges.size()) + " " + what + ":";
  for (std::size_t i = 0; i < std::min(edges.size(), kNamed); ++i)
    text += (i ? "; nodes " : " nodes ") + names.node(edges[i].nodes[0]) + "-" +
            names.node(edges[i].nodes[1]) + " of " + names.elements() +
            list_of(edges[i].elements, [&](int e) { return names.element(e); });
  text += edges.size() > kNamed ? "; ...\n" : "\n";
}

}  // namespace

bool SurfaceReport::ok() const {
  return !empty && !inward && !flat && out_of_range_elements.empty() && repeated_node_elements.empty() &&
         non_finite_nodes.empty() && boundary_edges.empty() && non_manifold_edges.empty() &&
         inconsistent_edges.empty() && pinched_nodes.empty() && unused_nodes.empty() && components.empty();
}

int SurfaceReport::first_element() const {
  for (const auto* elements : {&out_of_range_elements, &repeated_node_elements})
    if (!elements->empty()) return elements->front();
  for (const auto* edges : {&boundary_edges, &non_manifold_edges, &inconsistent_edges})
    if (!edges->empty()) return edges->front().elements.front();
  return components.empty() ? 0 : components.back().front();
}

std::string SurfaceReport::describe(const std::vector<int>& lines) const {
  const Names names{lines};
  const auto node = [&](int i) { return names.node(i); };
  const auto element = [&](int e) { return names.element(e); };
  std::string text;
  if (empty) text += "the surface has no elements\n";
  describe_list("elements with a node index out of range", out_of_range_elements, element, text);
  describe_list("elements with a repeated node", repeated_node_elements, element, text);
  describe_list("nodes that are not finite", non_finite_nodes, node, text);
  describe_edges("boundary edges (a hole in the surface)", boundary_edges, names, text);
  describe_edges(
      "non-manifold edges (more than two elements: a duplicate, an inner wall between chambers, or two "
      "sheets whose corner elements have the same diagonal)",
      non_manifold_edges, names, text);
  describe_edges("inconsistently oriented edges (two elements pass them in the same direction)",
                 inconsistent_edges, names, text);
  describe_list("pinched (non-manifold) nodes, where separate fans of elements meet", pinched_nodes, node,
                text);
  describe_list("nodes that no element uses", unused_nodes, node, text);
  if (!components.empty()) {
    std::vector<int> firsts;
    for (const std::vector<int>& component : components) firsts.push_back(component.front());
    describe_list(
        "disconnected components (a bag is one chamber, a sheet one piece), first " + names.elements(),
        firsts, element, text);
  }
  if (flat)
    text += "no volume: the sheets lie on each other; give an open initial shape\n";
  else if (inward)
    text += "inward orientation: the enclosed volume is " + shown(volume) + " m3, not positive\n";
  return text;
}

SurfaceReport check_closed_surface(const Eigen::Ref<const Eigen::Matrix3Xd>& nodes,
                                   const Elements& elements) {
  SurfaceReport report;
  report.empty = elements.cols() == 0;
  check_nodes_finite(nodes, report);
  check_indices(nodes.cols(), elements, report);
  if (report.empty || !report.out_of_range_elements.empty()) return report;
  const std::vector<HalfEdge> edges = sorted_edges(elements);
  const std::vector<EdgeGroup> groups = edge_groups(edges);
  check_edges(groups, report);
  check_components(groups, static_cast<int>(elements.cols()), report);
  check_fans(groups, elements, report);
  const bool closed = report.boundary_edges.empty() && report.non_manifold_edges.empty();
  if (closed && report.inconsistent_edges.empty() && report.non_finite_nodes.empty()) {
    report.volume = enclosed_volume(nodes, elements);
    report.inward = !(report.volume > 0.0);
    report.flat = is_flat(report.volume, element_areas(nodes, elements).sum());
  }
  return report;
}

void require_closed_surface(const Eigen::Ref<const Eigen::Matrix3Xd>& nodes, const Elements& elements) {
  require_closed_surface(check_closed_surface(nodes, elements));
}

void require_closed_surface(const SurfaceReport& report) {
  if (!report.ok())
    throw std::invalid_argument("surface is not a closed control volume:\n" + report.describe());
}

}  // namespace mesh
