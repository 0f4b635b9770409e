// SPDX-License-Identifier: Apache-2.0
// Springs by curves as straps: no force up to their free length, then linear.
#pragma once

#include "import/bag_deck.hpp"

namespace driver::imported {

struct StrapLaw {
  double stiffness = 0.0;  // [N/m], or of the curve's own abscissa
  double slack = 0.0;      // elongation from the start without force
  double misfit = 0.0;     // [-] largest error over the largest force
};

/// From where the curve's force rises above 0 to its last knot. Throws DeckFault if it never does.
StrapLaw strap_law(const Knots& force, Place at);

}  // namespace driver::imported
