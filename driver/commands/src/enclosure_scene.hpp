// SPDX-License-Identifier: Apache-2.0
// A case's tank as plain data of the enclosure.
#pragma once

#include "engine/scene.hpp"

namespace enclosure {
struct Scene;
}

namespace driver::commands {

/// With what sensors of time and signals do until `end` [s]. Throws CaseError, with the key, for a scene or a
/// part of it that the enclosure does not know.
enclosure::Scene enclosure_scene(const Scene& scene, double end);

}  // namespace driver::commands
