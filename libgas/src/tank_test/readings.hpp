// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "tank_test/smoothing_spline.hpp"

namespace gas {

/// Throws as the constructor of SmoothingSpline does.
void check_readings(std::span<const double> times, std::span<const double> readings, std::string_view name,
                    Noise noise);

/// Square roots of the weights: 1/(mean of the readings near i), because a weight from the reading itself
/// would favour low readings. For noise of full scale: 1 over the largest reading.
std::vector<double> root_weights(std::span<const double> readings, Noise noise);

}  // namespace gas
