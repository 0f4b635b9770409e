// SPDX-License-Identifier: Apache-2.0
// Scenes with mesh files of every format.
#pragma once

#include "engine/scene.hpp"

namespace driver {

/// read_scene() with read_any_mesh(). Refuses layers that cross at the start if the skin touches itself.
Scene load_scene(CaseDocument& document);

}  // namespace driver
