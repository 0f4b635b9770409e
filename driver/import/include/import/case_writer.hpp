// SPDX-License-Identifier: Apache-2.0
// The case of a bag: TOML, meshes and curves.
#pragma once

#include "import/bag_surface.hpp"

namespace driver::imported {

/// Files of the case: `name`.toml first, then bag.obj, perhaps bag_start.obj, and a CSV file for each long
/// curve. `program` and `deck` are named in comments.
DeckFiles write_case(const BagDeck& bag, const BagSurface& surface, const std::string& name,
                     const std::string& deck);

/// A name that is safe as a bare word of an OBJ file and in TOML.
std::string plain_name(std::string_view text);

}  // namespace driver::imported
