// SPDX-License-Identifier: Apache-2.0
// Measured curves of fabric in decks.
#pragma once

#include "export/deck.hpp"

namespace driver {

/// Converts nominal stress P over stretch minus 1, e, to second Piola-Kirchhoff stress over Green-Lagrange
/// strain, S = P/(1 + e) and E = e + e^2/2. Knots are added until lines between them are exact within `share`
/// of the last stress.
DeckCurve green_lagrange(const DeckCurve& nominal, double share);

/// Value of the curve, with its first and last pieces extended.
double value_on(const DeckCurve& curve, double x);

/// Adds the measured curves of the scene, with notes of changes. Precondition: `deck` has its format.
void add_fabric(const BagPart& bag, Deck& deck);

}  // namespace driver
