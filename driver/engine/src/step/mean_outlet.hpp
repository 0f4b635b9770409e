// SPDX-License-Identifier: Apache-2.0
// The mean of an outlet over the interval of a kick (J.11).
#pragma once

#include "engine/scene.hpp"

namespace driver {

/// Part [begin, end] of a kick of `length` [s] over which an outlet blows, in seconds since its firing.
struct BlowInterval {
  double begin, end, length;
};

/// Outlet whose mass flow and thrust mdot V0 are the integrals over `interval`, divided by its length. The
/// curves are integrated from knot to knot: exactly, but for rounding, with constant heat capacity and the
/// sonic law. `bag_pressure` [Pa] is held over the interval. Velocity, pressure and temperature are means by
/// mass. An interval without length has the values at its end.
jet::OutletState mean_outlet(const Scene& scene, const JetPart& part, const BlowInterval& interval,
                             double bag_pressure);

}  // namespace driver
