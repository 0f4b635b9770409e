// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "tank_test/identify.hpp"

namespace gas {

/// Heat conducted to the walls of a tank, from the readings after the flow has ended.
struct WallHeat {
  double conductance;  // [W/K] h A; may be slightly negative by noise
  double deviation;    // [W/K] its standard error, the pressure before firing being exact
  double slope;        // [W/(K Pa)] change with the pressure before firing, which gives the mass of gas
  double start;        // [s] from here on the readings show no flow
};

/// Fits the fall of the pressure after the flow to (G.40): from `start` on all of the mass is in the tank.
/// `noise` is the standard deviation of a reading, as a share of the reading or of the largest one.
/// The start is the first time after which a further term, large at first and then fading, is hidden by the
/// noise. Throws std::invalid_argument if the tail is too short, its gas is not warmer than the walls, no
/// start is found, or the pressure rises.
WallHeat fit_wall_heat(const TankTest& test, const TankReadings& readings, Noise kind, double noise,
                       double initial_pressure);

}  // namespace gas
