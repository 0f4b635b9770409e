// SPDX-License-Identifier: Apache-2.0
#include "deck_mesh.hpp"

#include <utility>

#include "mesh_builder.hpp"
#include "mesh_text.hpp"

namespace mesh {

int DeckMesh::open(const std::string& name) {
  files_.push_back(name);
  return static_cast<int>(files_.size()) - 1;
}

void DeckMesh::fail(const Place& place, const std::string& message) const {
  throw MeshFileError(files_[static_cast<std::size_t>(place.file)], place.line, place.column, message);
}

void DeckMesh::add_node(Id number, const Eigen::Vector3d& position, const Place& place) {
  const auto [known, is_new] = place_of_node_.try_emplace(number, place);
  if (!is_new) {
    const auto& [file, line, column] = known->second;
    fail(place, "node " + std::to_string(number) + " is repeated; first in line " + std::to_string(line) +
                    (file == place.file ? "" : " of " + files_[static_cast<std::size_t>(file)]));
  }
  nodes_.push_back({number, position});
}

void DeckMesh::add_shell(Id number, Id part, std::vector<Corner> corners, const Place& place) {
  if (!shell_numbers_.insert(number).second)
    fail(place, "element " + std::to_string(number) + " is repeated");
  if (corners.size() == 4 && corners[3].node == corners[2].node) corners.pop_back();
  shells_.push_back({number, part, std::move(corners)});
}

void DeckMesh::name_part(Id part, const std::string& title, const Place& place) {
  const std::size_t first = title.find_first_not_of(" \t");
  std::string name = first == std::string::npos
                         ? "part_" + std::to_string(part)
                         : title.substr(first, title.find_last_not_of(" \t") + 1 - first);
  for (char& c : name)
    if (static_cast<unsigned char>(c) <= ' ' || c == '#') c = '_';
  if (!used_names_.insert(name).second) name.append("_").append(std::to_string(part));
  if (!part_names_.try_emplace(part, name).second)
    fail(place, "part " + std::to_string(part) + " is repeated");
}

std::string DeckMesh::panel_of(Id part) const {
  const auto named = part_names_.find(part);
  return named == part_names_.end() ? "part_" + std::to_string(part) : named->second;
}

void DeckMesh::require_node(const Corner& corner) const {
  if (!place_of_node_.contains(corner.node))
    fail(corner.place, "node " + std::to_string(corner.node) + " is in no list of nodes of this deck");
}

/// Positions of nodes in the stress-free shape; empty if the deck has none that can be used.
DeckPlaces DeckMesh::design() {
  if (reference.empty()) return {};
  for (const auto& [number, corners] : reference.shells())
    for (const Corner& corner : corners) require_node(corner);
  DeckPlaces start;
  for (const Node& node : nodes_) start.emplace(node.number, node.position);
  auto shape = reference.shape(shells_, start);
  if (shape.half)
    neglect("the reference shape, because the deck lists only the nodes at seams of part " +
            std::to_string(*shape.half) + "");
  else if (!shape.two_places)
    return std::move(shape.places);
  if (!shape.two_places) return {};
  neglect("the reference shape, which has node " + std::to_string(*shape.two_places) +
          " in two places, as for panels cut flat");
  return {};
}

Mesh DeckMesh::build() {
  std::unordered_map<Id, int> index;
  for (const DeckShell& shell : shells_)
    for (const Corner& corner : shell.corners) {
      require_node(corner);
      index.try_emplace(corner.node, -1);
    }
  const DeckPlaces design_places = design();
  MeshBuilder builder;
  std::vector<Eigen::Vector3d> start;
  bool is_moved = false;
  for (const Node& node : nodes_)
    if (const auto used = index.find(node.number); used != index.end()) {
      used->second = builder.node_count();
      const auto listed = design_places.find(node.number);
      const Eigen::Vector3d& place = listed == design_places.end() ? node.position : listed->second;
      is_moved = is_moved || place != node.position;
      builder.add_node(place);
      start.push_back(node.position);
    }
  for (const DeckShell& shell : shells_) {
    std::vector<int> corners;
    for (const Corner& corner : shell.corners) corners.push_back(index.at(corner.node));
    builder.add_polygon(corners, panel_of(shell.part), shell.corners.front().place.line);
  }
  Mesh mesh = std::move(builder).finish();
  if (is_moved) mesh.start = Eigen::Map<const Eigen::Matrix3Xd>(start.front().data(), 3, mesh.nodes.cols());
  if (files_.size() > 1) mesh.line.clear();  // lines of several files are ambiguous
  mesh.node_sets = sets.of_mesh(index);
  const auto listed = [](const std::map<std::string, int>& counts) {
    std::vector<std::string> list;
    for (const auto& [name, count] : counts)
      list.push_back(count > 1 ? name + " (" + std::to_string(count) + ")" : name);
    return list;
  };
  mesh.other_elements = listed(elements_);
  mesh.skipped = listed(skipped_);
  mesh.neglected = listed(neglected_);
  return mesh;
}

}  // namespace mesh
