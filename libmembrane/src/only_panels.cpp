// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "membrane/mesh.hpp"

namespace membrane {

Mesh only_panels(const Mesh& mesh, const std::vector<std::string>& names) {
  std::vector<int> panels(mesh.panel_names.size(), -1),
      nodes(static_cast<std::size_t>(mesh.node_count()), -1);
  for (const auto& name : names) panels[static_cast<std::size_t>(panel_index(mesh, name))] = 0;
  std::vector<int> kept;
  for (int e = 0; e < mesh.element_count(); ++e)
    if (panels[static_cast<std::size_t>(mesh.panel[static_cast<std::size_t>(e)])] == 0) {
      kept.push_back(e);
      for (const int node : mesh.elements.col(e)) nodes[static_cast<std::size_t>(node)] = 0;
    }
  Mesh part;
  for (std::size_t p = 0; p < panels.size(); ++p)
    if (panels[p] == 0) {
      panels[p] = static_cast<int>(part.panel_names.size());
      part.panel_names.push_back(mesh.panel_names[p]);
    }
  int count = 0;
  for (int& node : nodes)
    if (node == 0) node = count++;
  part.nodes.resize(3, count);
  for (std::size_t n = 0; n < nodes.size(); ++n)
    if (nodes[n] >= 0) part.nodes.col(nodes[n]) = mesh.nodes.col(static_cast<Eigen::Index>(n));
  part.elements.resize(3, std::ssize(kept));
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const int e = kept[k];
    for (int corner = 0; corner < 3; ++corner)
      part.elements(corner, static_cast<Eigen::Index>(k)) =
          nodes[static_cast<std::size_t>(mesh.elements(corner, e))];
    part.panel.push_back(panels[static_cast<std::size_t>(mesh.panel[static_cast<std::size_t>(e)])]);
    if (!mesh.line.empty()) part.line.push_back(mesh.line[static_cast<std::size_t>(e)]);
  }
  part.split_quads = mesh.split_quads;
  part.other_elements = mesh.other_elements;
  part.skipped = mesh.skipped;
  part.included = mesh.included;
  return part;
}

}  // namespace membrane
