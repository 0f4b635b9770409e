// SPDX-License-Identifier: Apache-2.0
// Warnings of input that is allowed, but likely to be a mistake.
#pragma once

#include "engine/scene.hpp"

namespace driver {

/// Of gas that the vents, a shrinking tank or an inflator would take out of its range of temperatures.
void warn_of_range(Scene& scene);
/// Of numbers that are likely to be in another unit; the scene may be read in part.
void warn_of_units(Scene& scene);
/// Of parts that are likely to have no effect: a pendulum that misses the bag, a plate far from it.
void warn_of_idle_parts(Scene& scene);

}  // namespace driver
