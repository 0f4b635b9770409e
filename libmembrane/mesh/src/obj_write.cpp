// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <stdexcept>

#include "mesh/obj.hpp"
#include "mesh_text.hpp"

namespace mesh {
namespace {

void append_node(const Eigen::Vector3d& x, std::string& text) {
  text += "v";
  for (const double coordinate : x) {
    text += ' ';
    append_number(coordinate, text);
  }
  text += '\n';
}

void require_panel_name(const std::string& name) {
  const auto bad = [](char c) { return static_cast<unsigned char>(c) <= ' ' || c == '#'; };
  if (name.empty() || std::any_of(name.begin(), name.end(), bad))
    throw std::invalid_argument("panel_names: \"" + name + "\"" +
                                "; in OBJ a name must be non-empty, without blanks and #");
}

}  // namespace

std::string format_obj(const Mesh& mesh) {
  require_finite_nodes(mesh);
  for (const std::string& name : mesh.panel_names) require_panel_name(name);
  std::string text = "# nodes in metres\n";
  for (int i = 0; i < mesh.node_count(); ++i) append_node(mesh.nodes.col(i), text);
  int panel = -1;
  for (int e = 0; e < mesh.element_count(); ++e) {
    const int own = mesh.panel.at(static_cast<std::size_t>(e));
    if (own != panel) text += "g " + mesh.panel_names.at(static_cast<std::size_t>(panel = own)) + "\n";
    text += "f";
    for (int a = 0; a < 3; ++a) text += ' ' + std::to_string(mesh.elements(a, e) + 1);
    text += '\n';
  }
  return text;
}

}  // namespace mesh
