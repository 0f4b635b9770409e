// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "checks.hpp"
#include "mesh/mesh.hpp"
#include "mesh_text.hpp"

namespace mesh {

Mesh only_panels(const Mesh& mesh, const std::vector<std::string>& names) {
  require_nodes("only_panels", mesh.elements, mesh.nodes.cols());
  require_panels("only_panels", mesh);
  for (const auto& name : names) panel_index(mesh, name);  // refuses an unknown one
  const auto panel_of = [&](int element) -> const std::string& {
    const auto panel = mesh.panel[static_cast<std::size_t>(element)];
    return mesh.panel_names[static_cast<std::size_t>(panel)];
  };
  std::vector<int> kept, number(static_cast<std::size_t>(mesh.node_count()), -1);
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (std::ranges::find(names, panel_of(e)) == names.end()) continue;
    kept.push_back(e);
    for (const int node : mesh.elements.col(e)) number[static_cast<std::size_t>(node)] = 0;
  }
  MeshBuilder builder;
  std::vector<int> nodes;
  for (std::size_t n = 0; n < number.size(); ++n) {
    if (number[n] < 0) continue;
    number[n] = builder.node_count();
    nodes.push_back(static_cast<int>(n));
    builder.add_node(mesh.nodes.col(nodes.back()));
  }
  for (const int e : kept) {
    std::vector<int> corners;
    for (const int node : mesh.elements.col(e)) corners.push_back(number[static_cast<std::size_t>(node)]);
    const int line = mesh.line.empty() ? 0 : mesh.line[static_cast<std::size_t>(e)];
    builder.add_polygon(corners, panel_of(e), static_cast<std::size_t>(line));
  }
  Mesh part = std::move(builder).finish();
  if (mesh.line.empty()) part.line.clear();
  if (mesh.start) part.start = (*mesh.start)(Eigen::all, nodes);
  part.split_quads = mesh.split_quads;
  part.other_elements = mesh.other_elements;
  part.skipped = mesh.skipped;
  part.neglected = mesh.neglected;
  part.included = mesh.included;
  return part;
}

}  // namespace mesh
