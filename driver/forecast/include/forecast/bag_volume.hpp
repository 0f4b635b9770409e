// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "engine/scene.hpp"

namespace driver {

/// Volume [m3] of the scene's bag against overpressure [Pa], at rest on its supports, without jet, contact
/// and gravity. The first knot is the volume of the first shape, at 0. The others are at 100 Pa and, by
/// factors of 2, up to the pressure to which the inflators could bring the full volume (K.30). The bag is at
/// rest once damped motion has a kinetic energy below 1e-5 of p V and changes the volume by less than 1e-4.
/// Throws std::runtime_error if it does not come to rest. Empty after an interrupt.
std::optional<gas::Curve> bag_volume(const Scene& scene, bool quiet);

}  // namespace driver
