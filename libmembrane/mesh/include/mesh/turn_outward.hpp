// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.hpp"

namespace mesh {

/// Turns elements, so that neighbours run their common edge in opposite directions and each connected part
/// encloses a positive volume; a part with holes is closed towards its centre for that, and a flat one stays
/// as its first element is wound. Edges of more than two elements join nothing. Returns the number of
/// elements turned: their second and third node are exchanged, all else stays. Throws std::invalid_argument
/// for a node number out of range.
int turn_outward(Mesh& mesh);

}  // namespace mesh
