// SPDX-License-Identifier: Apache-2.0
// Private to the readers of decks: sets of nodes.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "deck_reference.hpp"
#include "mesh_text.hpp"
#include "node_sets.hpp"

namespace mesh {

/// Sets of nodes by the deck's numbers. The nodes need not exist.
class DeckSets {
 public:
  /// Begins a set, named by its title or, if that is blank, by its number.
  void begin(const std::string& title, DeckId number) {
    const std::size_t first = title.find_first_not_of(" \t\r"), last = title.find_last_not_of(" \t\r");
    sets_.push_back({first == std::string::npos ? "set_" + std::to_string(number)
                                                : panel_name(title.substr(first, last + 1 - first)),
                     {}});
  }
  void add(DeckId node) { sets_.back().nodes.push_back(node); }
  /// The sets of the nodes that `index` has.
  std::vector<NodeSet> of_mesh(const std::unordered_map<DeckId, int>& index) const {
    std::vector<NodeSet> found;
    for (const Set& set : sets_) {
      found.push_back({set.name, {}});
      for (const DeckId node : set.nodes)
        if (const auto used = index.find(node); used != index.end())
          found.back().nodes.push_back(used->second);
    }
    return renumbered_sets(found, [](int node) { return node; });
  }

 private:
  struct Set {
    std::string name;
    std::vector<DeckId> nodes;
  };
  std::vector<Set> sets_;
};

}  // namespace mesh
