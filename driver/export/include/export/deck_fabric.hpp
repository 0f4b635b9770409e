// SPDX-License-Identifier: Apache-2.0
// Measured curves of fabric as decks hold them.
#pragma once

#include "export/deck.hpp"

namespace driver {

/// The same law in other measures: nominal stress over stretch less 1 becomes second Piola-Kirchhoff stress
/// over Green-Lagrange strain, S = P/(1 + e) and E = e + e^2/2. Knots are added so that a line between two of
/// them is within `share` of the last stress.
DeckCurve green_lagrange(const DeckCurve& nominal, double share);

/// Value of the curve, whose first and last pieces go on beyond it.
double value_on(const DeckCurve& curve, double x);

/// Measured curves of the scene, with notes of what the deck makes of them. `deck` has its format.
void add_fabric(const BagPart& bag, Deck& deck);

}  // namespace driver
