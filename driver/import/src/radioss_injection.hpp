// SPDX-License-Identifier: Apache-2.0
// What the readers of both forms of a monitored volume, with gases as materials and with gases of its own,
// share.
#pragma once

#include "radioss_tables.hpp"

namespace driver::imported {

/// Time at which a sensor fires [s]; 0 without one. Throws DeckFault for sensors other than of time.
double start_of_sensor(RadiossContext& context, long sensor, Place at);

/// Gives the inflator the flow of a function of flow, or of cumulative mass; what that has at time zero is
/// there at once.
void inject(RadiossContext& context, BagInflator& inflator, long function, double factor, double time_unit,
            bool is_flow, Place at);

/// What of a volume's first lines has no counterpart: refuses scales of abscissas, and says the viscosity.
void require_plain_volume(RadiossContext& context, const DeckFields& scales, double viscosity);

/// Number of injectors of a volume, within what can be read.
long injectors_of(RadiossContext& context, std::size_t line);

}  // namespace driver::imported
