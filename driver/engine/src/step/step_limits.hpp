// SPDX-License-Identifier: Apache-2.0
// What is said of a step that its limits do not allow, with the key that helps.
#pragma once

#include "engine/state.hpp"

namespace driver {

/// Largest share of the thickness by which layers of the skin close in a step (K.47).
inline constexpr double kLargestApproach = 0.2;
/// Step [s] in which they close by that share, at the speed of the last step; infinite if none does.
double approach_limit(const Scene& scene, const State& state);

/// The given step is above the bound of stability. Throws StepError.
[[noreturn]] void refuse_step(const Scene& scene, const State& state, double given);

/// More than 1e9 steps like the chosen one would be left to the end. Throws StepError.
[[noreturn]] void refuse_short_step(const Scene& scene, const State& state);

}  // namespace driver
