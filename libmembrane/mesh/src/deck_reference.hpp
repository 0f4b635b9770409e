// SPDX-License-Identifier: Apache-2.0
// Private to the readers of decks: the stress-free shape that a deck gives beside its nodes.
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

/// Where a card stands: the number of its file, as DeckMesh::open gave it, line and column from 1.
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

/// Places of nodes by their numbers [file's unit].
using DeckPlaces = std::unordered_map<DeckId, Eigen::Vector3d>;

/// Lists of nodes with their places in the stress-free shape, each of one part or of all, and shells whose
/// corners have the places of other nodes.
class DeckReference {
 public:
  /// What the lists say of the nodes that shells use, and what is wrong with that.
  struct Shape {
    DeckPlaces places;                 // of the nodes that are listed
    std::optional<DeckId> two_places;  // of a node, as in panels that are cut flat
    std::optional<DeckId> half;        // a part with some listed nodes, which are of another part
  };

  /// A list of nodes of one part, or of all (0), follows. Their places are scaled about those of `origin`, or
  /// of the first node of the list (0).
  void begin(DeckId part, const Eigen::Vector3d& scale = Eigen::Vector3d::Ones(), DeckId origin = 0);
  void add_node(DeckId node, const Eigen::Vector3d& place) { lists_.back().nodes.emplace_back(node, place); }
  /// The corners of a shell are where these nodes are.
  void add_shell(DeckId number, std::vector<DeckCorner> corners) {
    shells_.insert_or_assign(number, std::move(corners));
  }
  bool empty() const { return lists_.empty() && shells_.empty(); }
  const std::map<DeckId, std::vector<DeckCorner>>& shells() const { return shells_; }

  /// `start` has the nodes of the deck, and all that shells() names.
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
