// SPDX-License-Identifier: Apache-2.0
// Means of runs and their standard errors.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace driver {

/// Mean, its standard error (sample deviation / sqrt(n)) and extremes over the runs.
struct Statistics {
  double mean = 0.0;
  double standard_error = 0.0;
  double minimum = 0.0;
  double maximum = 0.0;
  int count = 0;
};
Statistics statistics(const std::vector<double>& values);

/// True if two means differ by more than `rounding`, and by more than twice the standard error of their
/// difference where both have one.
bool means_differ(std::span<const Statistics> means, double rounding);

/// Where a mean would lie.
struct MeanRange {
  double low = 0.0, high = 0.0;
};

/// The mean of `s` and of `left_out` further values, all of them like the least of `s`, or like the greatest.
/// The further values may lie beyond. Nothing without a value; nor of one value if any is left out, because
/// one shows no spread.
std::optional<MeanRange> mean_with_left_out(const Statistics& s, int left_out);

}  // namespace driver
