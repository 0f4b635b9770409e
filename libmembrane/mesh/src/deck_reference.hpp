// SPDX-License-Identifier: Apache-2.0
// Private to the readers of decks: the stress-free shape of a deck.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace mesh {

using DeckId = long long;

/// Position of a card: the number of its file from DeckMesh::open, line and column from 1.
struct Place {
  int file;
  std::size_t line, column;
};

struct DeckCorner {
  DeckId node;
  Place place;
};

struct DeckShell {
  DeckId number, part;
  std::vector<DeckCorner> corners;
};

/// Positions of nodes by their numbers [file's unit].
using DeckPlaces = std::unordered_map<DeckId, Eigen::Vector3d>;

/// Lists of nodes with their positions in the stress-free shape, each for one part or for all, and shells
/// whose corners have the positions of other nodes.
class DeckReference {
 public:
  /// Positions of the nodes that shells use, by the lists, and faults of the lists.
  struct Shape {
    DeckPlaces places;                 // positions of the listed nodes
    std::optional<DeckId> two_places;  // a node with two positions, as in panels cut flat
    std::optional<DeckId> half;        // a part with only some of its nodes listed, by another part
  };

  /// Begins a list of nodes of one part, or of all (0). Their positions are scaled about the node `origin`,
  /// or about the first node of the list (0).
  void begin(DeckId part, const Eigen::Vector3d& scale = Eigen::Vector3d::Ones(), DeckId origin = 0);
  void add_node(DeckId node, const Eigen::Vector3d& place) { lists_.back().nodes.emplace_back(node, place); }
  /// The corners of a shell have the positions of these nodes.
  void add_shell(DeckId number, std::vector<DeckCorner> corners) {
    shells_.insert_or_assign(number, std::move(corners));
  }
  bool empty() const { return lists_.empty() && shells_.empty(); }
  const std::map<DeckId, std::vector<DeckCorner>>& shells() const { return shells_; }

  /// `start` has the nodes of the deck, including all nodes in shells().
  Shape shape(const std::vector<DeckShell>& shells, const DeckPlaces& start) const;

 private:
  struct List {
    DeckId part;
    Eigen::Vector3d scale;
    DeckId origin;
    std::vector<std::pair<DeckId, Eigen::Vector3d>> nodes;
  };

  std::vector<List> lists_;
  std::map<DeckId, std::vector<DeckCorner>> shells_;
};

}  // namespace mesh
