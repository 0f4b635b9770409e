// SPDX-License-Identifier: Apache-2.0
// Gas that a deck lets in at once, as decks do for an initial overpressure.
#pragma once

#include "import/bag_deck.hpp"
#include "import/import_report.hpp"

namespace driver::imported {

/// Time within which a mass that is there at time zero flows in [s]: less than a step.
double moment_of(const BagDeck& bag);

/// Mass that flows in [kg].
double mass_of(const Knots& flow);

/// Inflators whose whole flow is there `at_once`, of the bag's own gas, become initial pressure and
/// temperature: the same mass and internal energy in the volume [m3] at the start. The report names them.
void gas_at_start(BagDeck& bag, double volume, ImportReport& report);

}  // namespace driver::imported
