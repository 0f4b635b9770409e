// SPDX-License-Identifier: Apache-2.0
// Designs of experiments and what is computed from their results: plain numbers, no scenes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "many_runs/ensemble.hpp"

namespace driver {

/// One place in the unit cube for each factor, in [0, 1).
using UnitPoint = std::vector<double>;

/// Latin hypercube: each factor has one point in each of `count` equal intervals. The same for the same
/// `seed`. McKay, Beckman, Conover, Technometrics 21 (1979) 239.
std::vector<UnitPoint> latin_hypercube(int count, int factors, std::uint64_t seed);

/// The first `count` points of Sobol's sequence (GSL), from 1/2 on. Throws std::invalid_argument for more
/// than 40 factors, which GSL has no directions for.
std::vector<UnitPoint> sobol_sequence(int count, int factors);

/// Points for Sobol indices: for each of `rows` a point a, a point b, and for each factor a point that is a
/// with this factor's value of b. So there are rows * (factors + 2) points. Throws std::invalid_argument for
/// more than 20 factors. Saltelli et al., Comput. Phys. Commun. 181 (2010) 259.
std::vector<UnitPoint> sobol_index_points(int rows, int factors);

/// A value with the ends of its 95 % confidence interval.
struct Estimate {
  double value = 0.0, low = 0.0, high = 0.0;
};

/// Shares of the variance of one quantity that one factor explains: by itself, and with all others.
struct SobolIndex {
  Estimate first_order, total;
};

inline constexpr int fewest_sobol_rows = 8;

/// Indices of each factor from one value for each of sobol_index_points. A row with a value missing is left
/// out. First order by Saltelli (2010), total by Jansen (1999); the intervals are those of 1000 bootstrap
/// samples of the rows. Empty if fewer than 8 rows are whole or the values do not vary.
std::vector<SobolIndex> sobol_indices(std::span<const std::optional<double>> values, int factors);

/// Quadratic response surface over factors scaled to [-1, 1].
struct ResponseSurface {
  struct Term {
    std::vector<int> factors;  // none: the constant; one: linear; two: their product, or a square
    double coefficient = 0.0, standard_error = 0.0;
  };
  std::vector<Term> terms;
  double residual_deviation = 0.0;  // sqrt(sum of squares / degrees of freedom)
  double explained = 0.0;           // share of the variance (R^2)
};

/// Least squares (GSL). `points`: [point][factor] in [-1, 1]. Nothing if the points are fewer than the terms
/// and one more.
std::optional<ResponseSurface> fit_surface(const std::vector<std::vector<double>>& points,
                                           const std::vector<double>& values);

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

/// Fit of limit + coefficient * size^order.
struct Convergence {
  double limit = 0.0, coefficient = 0.0, order = 0.0;
  double residual = 0.0;  // largest distance of a value from the fit
};

/// Nothing for fewer than 3 sizes, or if no order from 0.1 to 8 fits best. Sizes are above 0 and differ.
std::optional<Convergence> fit_convergence(const std::vector<double>& sizes,
                                           const std::vector<double>& values);

/// True if the mean of `differences` has a sign of its own: its distance from 0 exceeds the quantile of
/// Student's t at error_rate / looks. So a test that looks `looks` times is wrong at most at `error_rate`
/// (Bonferroni).
bool sign_is_decided(const std::vector<double>& differences, int looks, double error_rate);

}  // namespace driver
