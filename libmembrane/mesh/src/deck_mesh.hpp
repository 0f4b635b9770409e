// SPDX-License-Identifier: Apache-2.0
// Private to the readers of decks: nodes, shells and parts by their numbers.
#pragma once

#include <Eigen/Core>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "deck_reference.hpp"
#include "deck_sets.hpp"
#include "mesh/mesh_file.hpp"

namespace mesh {

class DeckMesh {
 public:
  using Id = DeckId;
  using Corner = DeckCorner;

  /// Returns the number of a file that is read next.
  int open(const std::string& name);
  const std::string& first_file() const { return files_.front(); }
  /// Throws MeshFileError.
  [[noreturn]] void fail(const Place& place, const std::string& message) const;

  void add_node(Id number, const Eigen::Vector3d& position, const Place& place);
  /// 3 or 4 corners, the fourth left out if it is the third. All of these throw for a repeated number.
  void add_shell(Id number, Id part, std::vector<Corner> corners, const Place& place);
  void name_part(Id part, const std::string& title, const Place& place);
  /// Counts content that is not part of the mesh, by its name.
  void skip(const std::string& name, bool is_element) { (is_element ? elements_ : skipped_)[name] += 1; }
  /// Counts content that changes the bag and is not read, by its name.
  void neglect(const std::string& name) { neglected_[name] += 1; }
  DeckReference reference;  // the stress-free shape, for the readers of its cards
  DeckSets sets;            // of nodes

  bool has_shells() const { return !shells_.empty(); }
  /// Nodes in the order of the deck, those that a shell uses; panels in the order of their first shell.
  Mesh build();

 private:
  struct Node {
    Id number;
    Eigen::Vector3d position;
  };

  std::string panel_of(Id part) const;
  void require_node(const Corner& corner) const;
  DeckPlaces design();

  std::vector<std::string> files_;
  std::vector<Node> nodes_;
  std::unordered_map<Id, Place> place_of_node_;
  std::vector<DeckShell> shells_;
  std::set<Id> shell_numbers_;
  std::map<Id, std::string> part_names_;
  std::set<std::string> used_names_;
  std::map<std::string, int> elements_, skipped_, neglected_;
};

}  // namespace mesh
