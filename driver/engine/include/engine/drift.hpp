// SPDX-License-Identifier: Apache-2.0
// The physical drift of the energy (K.21): the step that bounds it, and what is said of what remains.
#pragma once

#include <string>

#include "engine/state.hpp"

namespace driver {

inline constexpr double kDriftWarned = 1e-3;      // share of the energy, from which on a warning is given
inline constexpr double kDriftInaccurate = 1e-2;  // from which on a run is no longer "done"

/// Largest drift of the recorded levels over the largest energy; in J where nothing holds energy.
double energy_drift(const State& state);

/// Step that bounds the drift (M.22), (M.24) [s]; without gas (M.24) alone. Writes nothing.
double drift_limit(const Scene& scene, const State& state);

/// Step that bounds the drift by layers of the skin that begin or cease to touch (K.48) [s].
double kink_limit(const Scene& scene, const State& state);

/// Energy of a skin below which its drift says nothing [J]; 0 without a skin.
double smallest_energy(const Scene& scene);

/// Energy that the drift is compared with [J], of a level (K.43).
double energy_scale(const Scene& scene, const State& state);
/// Kinetic and elastic energy of a level, and that of the pendulum's weight [J].
double mechanical_energy(const Scene& scene, const State& state);
/// Largest drift of the recorded levels over the largest mechanical energy; 0 if nothing moved.
double mechanical_drift(const State& state);

/// Says how large the drift is, of which term it can be, what sets the step, and which step would do.
std::string drift_text(const Scene& scene, const State& state);

}  // namespace driver
