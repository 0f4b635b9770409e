// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "export/deck.hpp"

namespace driver {

/// Initial gas, inflators, vents and leaks of the scene, with notes. `deck` has its parts.
void add_gas(const Scene& scene, Deck& deck);

}  // namespace driver
