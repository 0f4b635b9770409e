// SPDX-License-Identifier: Apache-2.0
// Surface of an impactor as triangles, for pictures and decks.
#pragma once

#include "coupling/impactor.hpp"
#include "mesh/mesh.hpp"

namespace driver {

/// Closed surface of a valid impactor in the body's axes [m], oriented outward. Its nodes are on the shape:
/// 32 around the body's z axis, and 15 rings or more between the poles. One panel "impactor".
mesh::Mesh impactor_picture(const coupling::Impactor& shape);

}  // namespace driver
