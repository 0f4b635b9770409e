// SPDX-License-Identifier: Apache-2.0
// [membrane.self_contact] -> SkinContactModel.
#pragma once

#include "engine/scene.hpp"

namespace driver {

/// [membrane.self_contact], of the scene's bag
void read_skin_contact(TableReader& membrane, Scene& scene);

}  // namespace driver
