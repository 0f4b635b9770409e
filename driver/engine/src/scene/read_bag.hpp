// SPDX-License-Identifier: Apache-2.0
// [membrane] -> BagPart.
#pragma once

#include "engine/scene.hpp"

namespace driver {

/// [membrane], [fabric]
void read_bag(TableReader& root, const MeshReader& read_mesh, Scene& scene);

}  // namespace driver
