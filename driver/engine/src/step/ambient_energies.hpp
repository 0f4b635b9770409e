// SPDX-License-Identifier: Apache-2.0
// Energies that the gas and its streams have at ambient temperature: what is left is sensible.
#pragma once

#include <vector>

#include "engine/state.hpp"

namespace driver {

/// Internal energy of each species at ambient temperature, which is held to their range [J/kg].
std::vector<double> species_at_ambient(const Scene& scene);
/// What gas and streams have at that temperature (K.43).
AmbientEnergies ambient_energies(const Scene& scene, const State& state);

}  // namespace driver
