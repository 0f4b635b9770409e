// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "export/deck.hpp"

namespace driver {

/// Knots of a curve of time that is shifted by `shift` [s], for a scene that ends at `end` [s]. With
/// `zero_before` the curve is zero before its first knot, like a flow that has not begun.
DeckCurve knots_of(const gas::Curve& curve, double shift, double end, bool zero_before = false);

/// Adds initial gas, inflators, vents and leaks of the scene, with notes. Precondition: `deck` has its parts.
void add_gas(const Scene& scene, Deck& deck);

}  // namespace driver
