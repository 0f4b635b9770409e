// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "tank_test/identify.hpp"

namespace gas {

/// Largest relative difference [-] between the smoothed tank pressure and that of the control-volume model
/// with the curves of `points`, from `initial_pressure` [Pa] on.
double forward_error(const TankTest& test, double initial_pressure, double conductance,
                     std::span<const IdentifiedPoint> points);

}  // namespace gas
