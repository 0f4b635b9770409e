// SPDX-License-Identifier: Apache-2.0
// The state of a simulation as bytes, to be kept in a file or sent to another process.
#pragma once

#include <string>
#include <string_view>

#include "engine/simulation.hpp"

namespace driver {

/// State and settings of a simulation, without the rows so far. Only the build that wrote the bytes reads
/// them, in a simulation of the same case; further steps have the same bits. Throws std::invalid_argument for
/// one that has failed, and while a setting waits for the next level.
std::string saved(const Simulation& simulation);

/// Gives a simulation of the same case that state, and forgets its own. Throws std::invalid_argument for
/// bytes of another build or case, or damaged ones, and then changes nothing.
void restore(Simulation& simulation, std::string_view bytes);

}  // namespace driver
