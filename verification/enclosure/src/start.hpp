// SPDX-License-Identifier: Apache-2.0
// Where a tube begins.
#pragma once

#include "tank.hpp"

namespace enclosure {

/// First box of a tube: time [s], exact; mass, temperature, mass fractions but the last, totals of the
/// streams.
struct Start {
  Ball time;
  Balls unknowns;
  Ball empty_until;  // [s] nothing is in an evacuated tank until then
};

/// Of the initial gas; or of an evacuated tank shortly after its first inflow. Throws Refusal.
Start start_of(const Tank& tank);

}  // namespace enclosure
