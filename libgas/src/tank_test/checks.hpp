// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "tank_test/identify.hpp"

namespace gas {

/// Throws std::invalid_argument that names the member out of range.
void check(const TankTest& test, const IdentifyOptions& options);

/// Throws ReadingError for a tank pressure that is not above 0, or a chamber pressure below the tank's by
/// more than the noise. Precondition: finite readings, as many as times.
void check_pressures(const TankReadings& readings, Noise noise);

}  // namespace gas
