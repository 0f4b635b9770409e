// SPDX-License-Identifier: Apache-2.0
// The Radioss deck.
#pragma once

#include "export/deck.hpp"
#include "export/units.hpp"

namespace driver {

/// The files of the deck.
DeckFiles write_radioss(const Deck& deck, const Units& units);

}  // namespace driver
