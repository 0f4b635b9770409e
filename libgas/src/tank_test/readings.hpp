// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "tank_test/smoothing_spline.hpp"

namespace gas {

/// Throws what the constructor of SmoothingSpline does.
void check_readings(std::span<const double> times, std::span<const double> readings, std::string_view name,
                    Noise noise);

/// 1/(mean of the readings near i): a weight from the reading itself would favour low ones. One over the
/// largest where the noise is the same over the record.
std::vector<double> root_weights(std::span<const double> readings, Noise noise);

}  // namespace gas
