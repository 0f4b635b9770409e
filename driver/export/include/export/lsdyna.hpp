// SPDX-License-Identifier: Apache-2.0
// The LS-DYNA deck.
#pragma once

#include "export/deck.hpp"
#include "export/units.hpp"

namespace driver {

/// The files of the deck.
DeckFiles write_lsdyna(const Deck& deck, const Units& units);

/// Lists the vents that an LS-DYNA deck, with its one opening, cannot represent.
void leave_out_lsdyna_vents(Deck& deck);

}  // namespace driver
