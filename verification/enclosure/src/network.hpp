// SPDX-License-Identifier: Apache-2.0
// When sensors and gates switch.
#pragma once

#include "ball.hpp"
#include "enclosure/scene.hpp"

namespace enclosure {

inline constexpr const char* order_is_open =
    "two sensors or gates switch within the uncertainty of their times; a smaller width may tell their order";

/// Of each node (sensors, then gates) the times [s] at which it comes on, goes off, comes on and so on, if
/// the pressure sensors switch at `events`, one list for each sensor, and not again. Throws Refusal if the
/// order of two uncertain times is open.
std::vector<Balls> switching_times(const Scene& scene, const std::vector<Balls>& events);

/// Sensors on which an inflator or a hole depends.
std::vector<bool> sensors_that_act(const Scene& scene);

}  // namespace enclosure
