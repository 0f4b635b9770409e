// SPDX-License-Identifier: Apache-2.0
// The LS-DYNA deck.
#pragma once

#include "export/deck.hpp"
#include "export/units.hpp"

namespace driver {

/// The files of the deck.
DeckFiles write_lsdyna(const Deck& deck, const Units& units);

/// Names the vents for which an LS-DYNA deck, with its one opening, has no place.
void leave_out_lsdyna_vents(Deck& deck);

}  // namespace driver
