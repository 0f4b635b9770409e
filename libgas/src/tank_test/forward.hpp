// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "tank_test/identify.hpp"

namespace gas {

/// Largest relative difference between the tank pressure that the control-volume model gives with the curves
/// of `points` and the smoothed one.
double forward_error(const TankTest& test, std::span<const IdentifiedPoint> points);

}  // namespace gas
