// SPDX-License-Identifier: Apache-2.0
// [pendulum], [contact] -> PendulumPart, ContactModel.
#pragma once

#include "engine/scene.hpp"

namespace driver {

/// [pendulum], [contact]
void read_pendulum(TableReader& root, Scene& scene);

}  // namespace driver
