// SPDX-License-Identifier: Apache-2.0
// Curves as cases allow them.
#pragma once

#include "import/bag_deck.hpp"
#include "import/import_report.hpp"

namespace driver::imported {

/// Sets values below 0 to 0, and says so.
void not_below_zero(Knots& knots, const std::string& key, ImportReport& report);

/// Cuts a curve of overpressure at 0, where flow begins.
void from_rest(Knots& knots);

/// A cumulative mass [kg] over time as a mass flow [kg/s], constant between its knots: exact. What is there
/// at time zero flows in within a `moment` [s].
Knots flow_of_mass(const Knots& mass, double moment);

/// Value at x, held outside the knots; the later of two at a jump.
double value_at(const Knots& knots, double x);

/// The knots with lines through the first and last two extended to `end`, as programs do that extrapolate.
void extend_to(Knots& knots, double end);

}  // namespace driver::imported
