// SPDX-License-Identifier: Apache-2.0
// Fabric of a bag, as the mappings of both programs share it: one law, one pair of curves and one law of
// leakage.
#pragma once

#include "import/bag_deck.hpp"
#include "import/import_report.hpp"

namespace driver::imported {

/// Sets the curve of warp (0) or weft (1), of stress that rises. Throws DeckFault if the bag has another one.
void take_thread(BagDeck& bag, std::size_t thread, const Knots& knots, Place at, ImportReport& report);

/// An isotropic fabric that carries compression, by its modulus and Poisson's ratio.
void take_elastic(BagFabric& fabric, double modulus, double poisson, const DeckCard& card,
                  ImportReport& report);

/// The bag's law from those of its parts. `card`, the bag's, is refused if these do not go together.
void take_law(BagDeck& bag, const std::vector<std::string>& laws, const DeckCard& card, ImportReport& report);

/// Sets how the bag leaks. Throws DeckFault if another part has another law.
void take_leak(BagDeck& bag, BagLeak law, const Knots& velocity, Place at);

/// A part that leaks through an orifice of this area [m2]; `law` names it.
void take_orifice(BagDeck& bag, double area, const std::string& source, const std::string& law,
                  ImportReport& report);

}  // namespace driver::imported
