// SPDX-License-Identifier: Apache-2.0
// Fits of results: a response surface, and a limit over sizes.
#pragma once

#include <optional>
#include <vector>

namespace driver {

/// Quadratic response surface over factors scaled to [-1, 1].
struct ResponseSurface {
  struct Term {
    std::vector<int> factors;  // none: the constant; one: linear; two: their product, or a square
    double coefficient = 0.0, standard_error = 0.0;
  };
  std::vector<Term> terms;
  double residual_deviation = 0.0;  // sqrt(sum of squares / degrees of freedom)
  double explained = 0.0;           // share of the variance (R^2)

  double at(const std::vector<double>& point) const;
};

/// Least squares (GSL). `points`: [point][factor] in [-1, 1]. Nothing if the points are fewer than the terms
/// and one more.
std::optional<ResponseSurface> fit_surface(const std::vector<std::vector<double>>& points,
                                           const std::vector<double>& values);

/// Fit of limit + coefficient * size^order.
struct Convergence {
  double limit = 0.0, coefficient = 0.0, order = 0.0;
  double residual = 0.0;  // largest distance of a value from the fit
};

/// Nothing for fewer than 3 sizes, or if no order from 0.1 to 8 fits best. Sizes are above 0 and differ.
std::optional<Convergence> fit_convergence(const std::vector<double>& sizes,
                                           const std::vector<double>& values);

}  // namespace driver
