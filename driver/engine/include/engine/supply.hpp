// SPDX-License-Identifier: Apache-2.0
// What the inflators send in up to the end of a scene. Triggers are taken to fire at 0.
#pragma once

#include <vector>

#include "engine/scene.hpp"

namespace driver {

/// Seconds of an inflow's own time that the scene sees.
double duration(const Scene& scene, const gas::Inflow& inflow);

struct Corner {
  double time;     // [s]
  gas::Side side;  // on which its flow is a limit
};

/// The ends of the pieces, up to the scene's end, on which its flow is linear; empty if it begins later.
std::vector<Corner> corners(const Scene& scene, const gas::Inflow& inflow);

/// An inflator at its greatest mass flow up to the scene's end; that is 0 if it begins later.
struct InflatorPeak {
  double time = 0.0;  // [s]
  gas::InflatorPoint point{};
};
InflatorPeak inflator_peak(const Scene& scene, std::size_t inflator);
/// The same of what flows through one outlet.
InflatorPeak outlet_peak(const Scene& scene, const JetPart& part);

/// Pressure [Pa] around an outlet, for estimates before a run: the ambient one, or that of the gas in a
/// vacuum.
double pressure_around(const Scene& scene);

/// Supply of the inflators up to the scene's end, as if every trigger came on at 0.
struct Supply {
  double mass = 0.0;       // [kg]
  double peak_flow = 0.0;  // [kg/s] of all inflators together
  double work = 0.0;       // [J] sum of gamma R int mdot T dt
  std::vector<double> mass_fractions;
  double temperature = 0.0;  // [K] mean by mass
};
Supply supply_of(const Scene& scene);

/// Mass flow [kg/s] of all inflators together at `time` [s].
double total_mass_flow(const Scene& scene, double time, gas::Side side = gas::Side::after);

}  // namespace driver
