// SPDX-License-Identifier: Apache-2.0
// The closed surface of a bag from the shells and segments of its deck.
#pragma once

#include "import/bag_deck.hpp"
#include "import/import_report.hpp"
#include "mesh/mesh.hpp"

namespace driver::imported {

struct BagSurface {
  mesh::Mesh mesh;                            // start positions as `nodes`
  std::optional<Eigen::Matrix3Xd> reference;  // stress-free positions of the same nodes, if others
  std::vector<long> numbers;                  // of the nodes in the deck
  std::map<long, int> index;                  // of a node of the deck in the mesh, from 0
  std::vector<std::string> caps;              // panels that close holes
};

/// Splits quads, joins elements to nodes on their edges, closes holes by caps on the nodes of their rims, and
/// turns all outward. Says in the report what it did, with sizes, and refuses there what cannot be a control
/// volume; `card` names the bag. Returns nothing then.
std::optional<BagSurface> surface_of(const BagDeck& bag, const DeckCard& card, ImportReport& report);

/// Triangles of a polygon, each with the largest smallest angle that is left; positions in its plane. Empty
/// if the polygon crosses itself.
std::vector<std::array<int, 3>> triangles_of(const std::vector<Eigen::Vector3d>& corners);

}  // namespace driver::imported
