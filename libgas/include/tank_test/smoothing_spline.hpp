// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "tank_test/reading_error.hpp"

namespace gas {

/// Value and slope of a spline at one time as sums over its coefficients from `first` on.
struct SplineBasis {
  static constexpr std::size_t kOrder = 6;  // quintic
  std::size_t first;                        // coefficient
  std::array<double, kOrder> value;         // of the kOrder functions that are not zero there
  std::array<double, kOrder> slope;         // [1/s]
};

/// A spline at one time.
struct SplinePoint {
  double value;  // in the unit of its coefficients
  double slope;  // [1/s]
};
/// The spline with these coefficients, at the time of the basis. Precondition: both of one SmoothingSpline.
SplinePoint evaluate(const SplineBasis& basis, std::span<const double> coefficients);

/// Smoothing spline through noisy readings y_i > 0 at times t_i whose noise is a fixed fraction of the
/// reading: quintic B-splines s(t) that minimise
///   sum w_i (y_i - s(t_i))^2 + lambda int s'''(x)^2 dx, w_i = 1/(mean of readings near i)^2,        (G.30)
/// x the time scaled to [0, 1], y scaled to a largest reading of 1. lambda minimises the generalised
/// cross-validation score                                                                            (G.31)
/// (Craven and Wahba, Numer. Math. 31, 1979), on a grid of ten values a decade. Its posterior as a Gaussian
/// process is the source of the bands, smoothing bias included on average over time (Wahba, J. R. Stat. Soc.
/// B 45, 1983, 133-150; Nychka, J. Am. Stat. Assoc. 83, 1988, 1134-1143).                             (G.32)
class SmoothingSpline {
 public:
  /// The constructor refuses fewer.
  static constexpr std::size_t kFewestReadings = 20;
  /// One interval holds four readings or more; at most this many intervals.
  static constexpr std::size_t kMostIntervals = 320;

  /// `name` is for errors: ReadingError (series "time" or `name`) for times that do not rise strictly or a
  /// reading that is not above 0, finite and at least a millionth of the largest, std::invalid_argument for
  /// fewer than kFewestReadings.
  SmoothingSpline(std::span<const double> times, std::span<const double> readings,
                  std::string_view name = "reading");
  ~SmoothingSpline();
  SmoothingSpline(SmoothingSpline&&) noexcept;

  double smoothing() const { return smoothing_; }                    // lambda, dimensionless
  double degrees_of_freedom() const { return degrees_of_freedom_; }  // trace of the smoother
  /// Standard deviation of a reading as a fraction of it, from the weighted residuals.
  double noise() const { return noise_; }

  /// Coefficients in the readings' unit.
  std::span<const double> coefficients() const { return coefficients_; }
  /// Basis at `time`, clamped to the record. Not from two threads at once.
  SplineBasis basis(double time) const;
  /// A draw from the posterior (G.32): coefficients for as many independent standard normal numbers.
  void draw(std::span<const double> normals, std::span<double> coefficients) const;

 private:
  struct Workspace;
  void fit(std::span<const double> times, std::span<const double> readings);
  double residual(std::span<const double> times, std::span<const double> readings,
                  std::span<const double> weights, std::span<const double> coefficients) const;

  double begin_;
  double length_;  // [s]
  double smoothing_ = 0.0;
  double degrees_of_freedom_ = 0.0;
  double noise_ = 0.0;
  std::vector<double> coefficients_;
  std::vector<double> spread_;  // square root of the posterior covariance, by rows
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace gas
