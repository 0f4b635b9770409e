// SPDX-License-Identifier: Apache-2.0
// Scenes with mesh files of every format.
#pragma once

#include "engine/scene.hpp"

namespace driver {

/// read_scene() with read_any_mesh().
Scene load_scene(CaseDocument& document);

}  // namespace driver
