// SPDX-License-Identifier: Apache-2.0
// How results spread if inputs are random: percentiles, chances and shares of the variance, each with its
// 95 % confidence interval. Plain numbers, no scenes.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "many_runs/sampling.hpp"
#include "many_runs/statistics.hpp"

namespace driver {

inline constexpr double percentiles[] = {5.0, 25.0, 50.0, 75.0, 95.0};
inline constexpr long fewest_for_outer = 72;  // points that the outer percentiles' intervals need

/// A percentile and its interval; an end is open if there are too few points.
struct Percentile {
  double percent = 0.0, value = 0.0;
  std::optional<double> low, high;
};

/// What the results of random inputs are like.
struct Spread {
  Estimate mean;  // Student's t over the means of the points
  double standard_error = 0.0;
  double standard_deviation = 0.0;      // of a single run
  std::vector<Percentile> percentiles;  // of single runs
  long points = 0, runs = 0;
};

/// Results at independent points, `of_points[point][run]`; points without a run do not count. A percentile is
/// that of Hazen. Its interval is that of the order statistics (Conover, Practical Nonparametric Statistics,
/// 1999, section 3.2), which holds for any distribution, for as many independent runs as there are points: it
/// is too wide rather than too narrow if runs of a point have something of their own, or if the points are
/// spread evenly. Nothing for fewer than 2 points.
std::optional<Spread> spread(const std::vector<std::vector<double>>& of_points);

/// Chance that a run lies beyond a limit, given the share of the runs that do and the number of points:
/// Clopper and Pearson, Biometrika 26 (1934) 404. It holds for any distribution, as the interval of a
/// percentile does.
Estimate chance(double share, long points);

/// What one factor does to a result: a quadratic through all points.
struct Trend {
  Estimate share;       // of the variance, that the factor explains by itself (first order)
  double change = 0.0;  // of the result, for one standard deviation of the factor at its mean
  double constant = 0.0, slope = 0.0, bend = 0.0;  // over (x - mean) / deviation
  double mean = 0.0, deviation = 0.0;              // of the factor

  double at(double x) const;
};

/// The share is the adjusted R^2, its interval Fisher's of a correlation. The factors need not be
/// independent. Nothing for fewer than 5 points, or if the factor or the result does not vary.
std::optional<Trend> trend(const std::vector<double>& factor, const std::vector<double>& values);

}  // namespace driver
