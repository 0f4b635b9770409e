// SPDX-License-Identifier: Apache-2.0
#include "scene/bag_supports.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
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

// The node of the mesh that has this number in its file, from 1.
int node_numbered(TableReader& table, const std::string& key, double number, const BagMesh& source) {
  const auto count = static_cast<double>(
      source.node_of_file.empty() ? source.mesh.node_count() : static_cast<int>(source.node_of_file.size()));
  if (number != std::floor(number) || number < 1.0 || number > count)
    table.fail(
        key, fmt::format("names node {:g}, allowed: numbers of the mesh's nodes, 1 to {:g}", number, count));
  const auto index = static_cast<int>(number) - 1;
  const int node = source.node_of_file.empty() ? index : source.node_of_file[static_cast<std::size_t>(index)];
  if (node < 0)
    table.fail(key,
               fmt::format("names node {:g}, which is left out with the elements that have no area", number));
  return node;
}

std::vector<int> nodes_numbered(TableReader& table, const std::string& key, const BagMesh& source) {
  std::vector<int> nodes;
  if (!table.has(key)) return nodes;
  for (const double number : table.at(key).numbers(Bounds{1.0, 1e9, false, "whole numbers of 1 or more"}))
    nodes.push_back(node_numbered(table, key, number, source));
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

std::vector<int> sliding_nodes(TableReader& reader, const BagMesh& source) {
  const bool in_box = reader.has("low") || reader.has("high"), by_number = reader.has("nodes");
  if (in_box + by_number + reader.has("panels") != 1)
    reader.fail("panels",
                "or `nodes`, or a box, `low` and `high`: one of the three must select the sliding nodes");
  if (by_number) return nodes_numbered(reader, "nodes", source);
  return in_box ? nodes_in_box(reader, source.mesh) : nodes_of_panels(reader, "panels", source.mesh);
}

void read_rollers(TableReader& table, const BagMesh& source, membrane::BagDescription& bag) {
  for (auto& reader : table.tables("roller")) {
    const auto nodes = sliding_nodes(reader, source);
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

// One end of a strap by its number in the mesh file.
int numbered_end(TableReader& reader, const std::string& key, const BagMesh& source) {
  const double number = reader.at(key).number(Bounds{1.0, 1e9, false, "a whole number of 1 or more"});
  return node_numbered(reader, key, number, source);
}

void read_straps(TableReader& table, const BagMesh& source, std::vector<membrane::Strap>& straps) {
  for (auto& reader : table.tables("strap")) {
    membrane::Strap strap;
    const bool points =
        reader.has("from") || reader.has("to") || reader.has("from_panel") || reader.has("to_panel");
    if (reader.has("from_node") || reader.has("to_node")) {
      strap.node_a = numbered_end(reader, "from_node", source);
      strap.node_b = numbered_end(reader, "to_node", source);
    } else if (points || straps.size() >= source.strap_anchors.size()) {
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
  for (const int node : nodes_numbered(table, "fixed_nodes", source)) bag.fixed_nodes.push_back(node);
  std::ranges::sort(bag.fixed_nodes);
  bag.fixed_nodes.erase(std::unique(bag.fixed_nodes.begin(), bag.fixed_nodes.end()), bag.fixed_nodes.end());
  read_rollers(table, source, bag);
  read_straps(table, source, bag.straps);
  read_plate(table, bag);
}

}  // namespace driver
