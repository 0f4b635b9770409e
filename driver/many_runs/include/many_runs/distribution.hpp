// SPDX-License-Identifier: Apache-2.0
// Distributions of random inputs, each by its quantiles, and their correlation: plain numbers, no scenes.
#pragma once

#include <span>
#include <variant>
#include <vector>

#include "many_runs/sampling.hpp"

namespace driver {

/// Normal, cut off outside [low, high].
struct NormalDistribution {
  double mean = 0.0, standard_deviation = 1.0;  // of the whole one; the latter above 0
  double low, high;                             // low < high; infinite: not cut off
};

/// Triangular: its density rises from low to mode and falls to high. low <= mode <= high, low < high.
struct TriangularDistribution {
  double low = 0.0, mode = 0.0, high = 0.0;
};

/// Log-normal: 68 % of the values lie between median / factor and median * factor.
struct LogNormalDistribution {
  double median = 1.0;  // above 0
  double factor = 1.0;  // above 1
};

using Distribution = std::variant<NormalDistribution, TriangularDistribution, LogNormalDistribution>;

/// The value below which a share `unit` in (0, 1) of all values lies.
double quantile(const Distribution& distribution, double unit);

/// Share of a normal distribution that its limits leave.
double share_inside(const NormalDistribution& distribution);

/// Correlation coefficient of two normal numbers whose ranks have the coefficient `of_ranks` (Spearman):
/// 2 sin(pi/6 of_ranks). Pearson, Mathematical Contributions to the Theory of Evolution XVI (1907).
double coefficient_from_ranks(double of_ranks);

/// Correlation of random inputs by a Gaussian copula: Cholesky factor of the coefficients of their normal
/// numbers. Nelsen, An Introduction to Copulas (2006), section 2.3.
class Correlation {
 public:
  explicit Correlation(std::size_t inputs);
  /// Coefficient in (-1, 1) of two inputs that differ.
  void set(std::size_t a, std::size_t b, double coefficient);
  /// Coefficient that both inputs have so far; 0 if none is set.
  double coefficient(std::size_t a, std::size_t b) const { return matrix_[a * inputs_ + b]; }
  /// False if no random numbers have these coefficients together. To be called before apply().
  bool factorise();
  /// Makes a point of independent uniform numbers one of correlated uniform numbers, in (0, 1). The first
  /// input stays as it is, and so does one without a correlation.
  void apply(UnitPoint& point) const;

 private:
  std::size_t inputs_;
  std::vector<double> matrix_, factor_;  // row by row
};

}  // namespace driver
