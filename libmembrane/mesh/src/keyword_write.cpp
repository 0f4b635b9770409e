// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <stdexcept>

#include "mesh/keyword.hpp"
#include "mesh_text.hpp"

namespace mesh {
namespace {

void require_title(const std::string& name) {
  const auto bad = [](char c) { return static_cast<unsigned char>(c) < ' '; };
  if (name.empty() || name.front() == '*' || name.front() == '$' ||
      std::any_of(name.begin(), name.end(), bad))
    throw std::invalid_argument(
        "panel_names: \"" + name +
        "\"; a name must not be empty, have control characters, or begin with * or $");
}

void append_card(int id, const Eigen::Vector3d& x, std::string& text) {
  text += std::to_string(id);
  for (const double coordinate : x) {
    text += ',';
    append_number(coordinate, text);
  }
  text += '\n';
}

}  // namespace

std::string format_keyword(const Mesh& mesh) {
  require_finite_nodes(mesh);
  for (const std::string& name : mesh.panel_names) require_title(name);
  std::string text = "*KEYWORD LONG=Y\n$ nodes in metres\n";
  for (std::size_t panel = 0; panel < mesh.panel_names.size(); ++panel)
    text += "*PART\n" + mesh.panel_names[panel] + "\n" + std::to_string(panel + 1) + ",\n";
  text += "*NODE\n";
  for (int i = 0; i < mesh.node_count(); ++i) append_card(i + 1, mesh.nodes.col(i), text);
  text += "*ELEMENT_SHELL\n";
  for (int e = 0; e < mesh.element_count(); ++e) {
    text += std::to_string(e + 1) + ',' + std::to_string(mesh.panel.at(static_cast<std::size_t>(e)) + 1);
    for (const int corner : {0, 1, 2, 2}) text += ',' + std::to_string(mesh.elements(corner, e) + 1);
    text += '\n';
  }
  return text + "*END\n";
}

}  // namespace mesh
