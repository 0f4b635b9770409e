// SPDX-License-Identifier: Apache-2.0
#include "export/writers.hpp"

namespace driver {
DeckFiles write_lsdyna(const Deck& deck, const Units&) {
  return {{"bag.k", deck.scene->name}};
}
}  // namespace driver
