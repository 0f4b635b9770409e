// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "driver/scene.hpp"

namespace driver {

/// Volume [m3] of the scene's bag against overpressure [Pa], at rest on its supports, without jet, contact
/// and gravity: that of its first shape at 0, then at 100 Pa and by factors of 2 up to what the inflators
/// could bring the full volume to, (K.30). Rest: damped motion until its kinetic energy is below 1e-5 of p V
/// and the volume changes by less than 1e-4. Throws std::runtime_error if that does not come; nothing
/// after an interrupt.
std::optional<gas::Curve> bag_volume(const Scene& scene, bool quiet);

}  // namespace driver
