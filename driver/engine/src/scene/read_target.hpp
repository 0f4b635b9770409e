// SPDX-License-Identifier: Apache-2.0
// [target] -> TargetPart.
#pragma once

#include "engine/scene.hpp"

namespace driver {

/// [target]
void read_target(TableReader& root, Scene& scene);

}  // namespace driver
