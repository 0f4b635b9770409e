// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

// Functions of two numbers that nearly cancel, to all digits.
namespace closed_form {

/// log(a/b), also for a -> b; a, b > 0.
inline double log_ratio(double a, double b) {
  return std::abs(a - b) < 0.5 * b ? std::log1p((a - b) / b) : std::log(a / b);
}

/// 1 - sin(x)/x, also for x -> 0.
inline double sinc_defect(double x) {
  if (std::abs(x) > 1.0) return 1.0 - std::sin(x) / x;
  double sum = 0.0, term = x * x / 6.0;
  for (int k = 4; k < 24; k += 2) {
    sum += term;
    term *= -x * x / (k * (k + 1));
  }
  return sum;
}

}  // namespace closed_form
