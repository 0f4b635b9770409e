// SPDX-License-Identifier: Apache-2.0
#include "scene/bag_supports.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

namespace driver {
namespace {

std::vector<int> nodes_of_panels(TableReader& table, const std::string& key, const mesh::Mesh& mesh) {
  std::vector<int> nodes;
  const auto names = table.at(key).texts();
  table.located(key, [&] {
    for (const auto& name : names)
      for (const int node : mesh::panel_nodes(mesh, name)) nodes.push_back(node);
  });
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

// Nodes of the design shape in a box.
std::vector<int> nodes_in_box(TableReader& table, const mesh::Mesh& mesh) {
  const Eigen::Vector3d low = table.at("low").vector("m"), high = table.at("high").vector("m");
  std::vector<int> nodes;
  for (int node = 0; node < mesh.node_count(); ++node)
    if ((mesh.nodes.col(node).array() >= low.array()).all() &&
        (mesh.nodes.col(node).array() <= high.array()).all())
      nodes.push_back(node);
  if (nodes.empty()) table.fail("low", "and `high` are the corners of a box without a node of the mesh");
  return nodes;
}

void read_rollers(TableReader& table, const mesh::Mesh& mesh, membrane::BagDescription& bag) {
  for (auto& reader : table.tables("roller")) {
    const bool in_box = reader.has("low") || reader.has("high");
    if (in_box == reader.has("panels"))
      reader.fail("panels", "or a box, `low` and `high`: one of the two must select the sliding nodes");
    const auto nodes = in_box ? nodes_in_box(reader, mesh) : nodes_of_panels(reader, "panels", mesh);
    if (nodes.empty()) reader.fail("panels", "is empty, needed: names of panels");
    const auto directions = reader.at("directions").texts("needed");
    if (directions.empty())
      reader.fail("directions", "is missing or empty, needed: some of \"x\", \"y\" and \"z\"");
    for (const std::string& direction : directions) {
      const auto axis = std::string_view("xyz").find(direction);
      if (direction.size() != 1 || axis == std::string_view::npos)
        reader.fail("directions", fmt::format("names \"{}\", allowed: \"x\", \"y\" and \"z\"", direction));
      auto& held = bag.held_nodes[axis];
      held.insert(held.end(), nodes.begin(), nodes.end());
    }
    reader.finish();
  }
}

double longest_side(const mesh::Mesh& mesh) {
  double longest = 0.0;
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int i = 0; i < 3; ++i)
      longest = std::max(
          longest,
          (mesh.nodes.col(mesh.elements(i, e)) - mesh.nodes.col(mesh.elements((i + 1) % 3, e))).norm());
  return longest;
}

int nearest_of_panel(TableReader& reader, const std::string& key, const std::string& name,
                     const mesh::Mesh& mesh, const Eigen::Vector3d& point) {
  int nearest = -1;
  reader.located(key, [&] {
    const auto distance = [&](int node) { return (mesh.nodes.col(node) - point).squaredNorm(); };
    nearest = std::ranges::min(mesh::panel_nodes(mesh, name), {}, distance);
  });
  return nearest;
}

// Sheets that lie on each other in the design shape have nodes at the same place: without a panel, a point
// does not say which of them it means.
void require_one_panel(TableReader& reader, const std::string& key, const mesh::Mesh& mesh, int node,
                       double same_place) {
  std::vector<std::string> panels = panels_of_node(mesh, node), others;
  for (int other = 0; other < mesh.node_count(); ++other) {
    if (other == node || (mesh.nodes.col(other) - mesh.nodes.col(node)).norm() > same_place) continue;
    for (const std::string& name : panels_of_node(mesh, other))
      if (std::find(panels.begin(), panels.end(), name) == panels.end()) others.push_back(name);
  }
  if (others.empty()) return;
  panels.insert(panels.end(), others.begin(), others.end());
  std::sort(panels.begin(), panels.end());
  panels.erase(std::unique(panels.begin(), panels.end()), panels.end());
  reader.fail(
      key, fmt::format("is nearest to nodes at one place of the panels \"{}\": set `{}_panel` to one of them",
                       fmt::join(panels, "\", \""), key));
}

// The node nearest to a point of the design shape, of all panels or of one; a point further off than the mesh
// is coarse is a slip.
int anchor(TableReader& reader, const std::string& key, const std::optional<std::string>& panel,
           const mesh::Mesh& mesh) {
  const Eigen::Vector3d point = reader.at(key).vector("m");
  const int node =
      panel ? nearest_of_panel(reader, key + "_panel", *panel, mesh, point) : mesh::nearest_node(mesh, point);
  const double distance = (mesh.nodes.col(node) - point).norm(), longest = longest_side(mesh);
  if (distance > longest)
    reader.fail(key,
                fmt::format("is {:.3g} m from the nearest node, allowed: {:.3g} m, the longest element side",
                            distance, longest));
  constexpr double rounding = 1e-9;  // of a side: what decimals of a mesh file leave
  if (!panel) require_one_panel(reader, key, mesh, node, rounding * longest);
  return node;
}

void read_straps(TableReader& table, const BagMesh& source, std::vector<membrane::Strap>& straps) {
  for (auto& reader : table.tables("strap")) {
    membrane::Strap strap;
    const bool points =
        reader.has("from") || reader.has("to") || reader.has("from_panel") || reader.has("to_panel");
    if (points || straps.size() >= source.strap_anchors.size()) {
      std::optional<std::string> from, to;
      if (reader.has("from_panel")) from = reader.at("from_panel").text();
      if (reader.has("to_panel")) to = reader.at("to_panel").text();
      strap.node_a = anchor(reader, "from", from, source.mesh);
      strap.node_b = anchor(reader, "to", to, source.mesh);
    } else {
      strap.node_a = source.strap_anchors[straps.size()][0];
      strap.node_b = source.strap_anchors[straps.size()][1];
    }
    strap.stiffness = reader.at("stiffness").number(positive.in("N/m"));
    strap.free_length = reader.at("free_length").number(positive.in("m"));
    reader.finish();
    straps.push_back(strap);
  }
}

void read_plate(TableReader& table, membrane::BagDescription& bag) {
  auto reader = table.optional_table("plate");
  if (!reader) return;
  membrane::Plate plate;
  plate.point = reader->at("point").vector("m");
  plate.normal = reader->at("normal").vector("");
  plate.stiffness = reader->at("stiffness").optional_number(positive.in("Pa/m"));
  reader->finish();
  bag.plates.push_back(plate);
}

}  // namespace

void read_supports(TableReader& table, const BagMesh& source, membrane::BagDescription& bag) {
  bag.fixed_nodes = nodes_of_panels(table, "fixed_panels", source.mesh);
  read_rollers(table, source.mesh, bag);
  read_straps(table, source, bag.straps);
  read_plate(table, bag);
}

}  // namespace driver
