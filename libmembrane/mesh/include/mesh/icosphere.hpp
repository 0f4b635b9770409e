// SPDX-License-Identifier: Apache-2.0
// Structured meshes for verification: icosphere and plane rectangle.
#pragma once

#include "mesh/mesh.hpp"

namespace mesh {

/// Icosahedron inscribed in a sphere of `radius` [m]. Each element is split in four `levels` times at the
/// midpoints of its edges, which are moved onto the sphere. 20 * 4^levels elements, 10 * 4^levels + 2 nodes,
/// one panel "sphere", oriented outward. Throws std::invalid_argument unless radius > 0 and finite and
/// 0 <= levels <= 9.
Mesh icosphere(double radius, int levels);

/// Diagonals of a rectangle's cells: all parallel, or alternating.
enum class Diagonals { uniform, union_jack };

/// Open plane mesh [0, width] x [0, height] [m] in z = 0, normal +z, of nx * ny cells of two elements. Node
/// i + j (nx + 1) is at (i width / nx, j height / ny). One panel "sheet". Throws std::invalid_argument for
/// arguments that are not positive.
Mesh rectangle(int nx, int ny, double width, double height, Diagonals diagonals);

}  // namespace mesh
