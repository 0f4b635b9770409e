// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "export/deck.hpp"

namespace driver {

/// Knots of a curve of time that is shifted by `shift` [s], for a scene that ends at `end` [s].
DeckCurve knots_of(const gas::Curve& curve, double shift, double end);

/// Initial gas, inflators, vents and leaks of the scene, with notes. `deck` has its parts.
void add_gas(const Scene& scene, Deck& deck);

}  // namespace driver
