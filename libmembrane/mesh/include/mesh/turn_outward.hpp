// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh.hpp"

namespace mesh {

/// Turns elements so that neighbours pass their common edge in opposite directions and each connected part
/// encloses a positive volume. A part with holes is closed towards its centre for this; a flat part keeps the
/// winding of its first element. Edges of more than two elements do not connect. A turned element exchanges
/// its second and third node; nothing else changes. Returns the number of elements turned. Throws
/// std::invalid_argument for a node number out of range.
int turn_outward(Mesh& mesh);

}  // namespace mesh
