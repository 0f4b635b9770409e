// SPDX-License-Identifier: Apache-2.0
#include "mesh/stl.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <vector>

#include "mesh_builder.hpp"
#include "mesh_text.hpp"
#include "mesh_tokens.hpp"

namespace mesh {
namespace {

class StlParser {
 public:
  StlParser(std::string_view text, const std::string& name) : words_(text, name) {}

  Mesh parse() {
    while (!words_.at_end()) solid();
    if (mesh_.empty()) throw MeshFileError(words_.name(), 0, 0, "the file has no facets");
    return std::move(mesh_).finish();
  }

 private:
  void solid() {
    words_.expect("solid");
    panel_ = panel_name(words_.rest_of_line());
    while (true) {
      const MeshWord word = words_.word("facet or endsolid");
      const std::string key = upper_case(word.text);
      if (key == "ENDSOLID") break;
      if (key != "FACET") words_.fail(word, shown(word.text) + " is found instead of facet or endsolid");
      facet(word);
    }
    words_.rest_of_line();
  }

  void facet(const MeshWord& begin) {
    words_.expect("normal");
    // Some programs write nan for a normal that they cannot compute.
    for (int i = 0; i < 3; ++i) words_.word("a component of the normal");
    words_.expect("outer");
    words_.expect("loop");
    std::array<int, 3> corners{};
    for (int& corner : corners) {
      words_.expect("vertex");
      corner = node();
    }
    if (const MeshWord end = words_.peek("endloop"); upper_case(end.text) == "VERTEX")
      words_.fail(end, "a facet has three corners; this is the fourth");
    words_.expect("endloop");
    words_.expect("endfacet");
    mesh_.add_polygon(corners, panel_, begin.line);
  }

  int node() {
    std::array<double, 3> x{};
    for (double& coordinate : x) coordinate = words_.number("a coordinate") + 0.0;  // -0 equals 0
    const auto [place, is_new] = nodes_.try_emplace(x, mesh_.node_count());
    if (is_new) mesh_.add_node({x[0], x[1], x[2]});
    return place->second;
  }

  TokenReader words_;
  MeshBuilder mesh_;
  std::map<std::array<double, 3>, int> nodes_;
  std::string panel_;
};

}  // namespace

bool is_stl_text(std::string_view bytes) {
  const std::string_view text = bytes.substr(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
  return upper_case(text.substr(0, 5)) == "SOLID" && bytes.find('\0') == std::string_view::npos;
}

Mesh parse_stl(std::string_view text, const std::string& name) {
  return StlParser(text, name).parse();
}

std::string format_stl(const Mesh& mesh) {
  require_finite_nodes(mesh);
  std::string text;
  const auto row = [&](const char* word, const Eigen::Vector3d& x) {
    text += word;
    for (const double value : x) {
      text += ' ';
      append_number(value, text);
    }
    text += '\n';
  };
  std::vector<std::vector<int>> elements(mesh.panel_names.size());
  for (int e = 0; e < mesh.element_count(); ++e)
    elements.at(static_cast<std::size_t>(mesh.panel.at(static_cast<std::size_t>(e)))).push_back(e);
  for (std::size_t panel = 0; panel < mesh.panel_names.size(); ++panel) {
    const std::string& name = mesh.panel_names[panel];
    if (panel_name(name) != name)
      throw std::invalid_argument("panel_names: \"" + name +
                                  "\"; in STL a name must be non-empty, without blanks and #");
    text += "solid " + name + "\n";
    for (const int e : elements[panel]) {
      const Eigen::Vector3d a = mesh.nodes.col(mesh.elements(0, e)), b = mesh.nodes.col(mesh.elements(1, e)),
                            c = mesh.nodes.col(mesh.elements(2, e));
      row("facet normal", Eigen::Vector3d((b - a).cross(c - a).normalized()));
      text += "outer loop\n";
      for (const auto& x : {a, b, c}) row("vertex", x);
      text += "endloop\nendfacet\n";
    }
    text += "endsolid " + name + "\n";
  }
  return text;
}

}  // namespace mesh
