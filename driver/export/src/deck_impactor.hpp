// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "export/deck.hpp"

namespace driver {

/// Adds the impactor of the scene, its load and gravity over time, with notes. Precondition: `deck` has its
/// format.
void add_impactor(const Scene& scene, Deck& deck);

}  // namespace driver
