// SPDX-License-Identifier: Apache-2.0
// A signal at rising times: interpolation with an error estimate, and means over time.
#pragma once

#include <span>

namespace driver {

struct Sample {
  double value = 0.0;  // linear between the neighbours; the end value beyond the ends
  // Twice |linear - cubic through two neighbours on each side|, since the cubic errs too; 0 at a sample.
  double doubt = 0.0;
};

/// Precondition: 3 samples or more. At the ends the cubic uses neighbours on one side.
Sample interpolate(std::span<const double> time, std::span<const double> values, double t);

/// sqrt(int v^2 dt / T) by the trapezoidal rule; for one row its magnitude.
double root_mean_square(std::span<const double> time, std::span<const double> values);

}  // namespace driver
