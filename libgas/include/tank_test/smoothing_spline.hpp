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

/// Weights of kOrder coefficients in the value and the slope of a spline at one time.
struct SplineBasis {
  static constexpr std::size_t kOrder = 6;  // quintic
  std::size_t first;                        // number of the first coefficient
  std::array<double, kOrder> value;         // [basis function] of those that are not zero at this time
  std::array<double, kOrder> slope;         // [basis function] [1/s]
};

/// A spline at one time.
struct SplinePoint {
  double value;  // in the unit of its coefficients
  double slope;  // [unit of the coefficients/s]
};
/// Spline with these coefficients at the time of `basis`. Throws std::invalid_argument if the coefficients
/// are too few.
SplinePoint evaluate(const SplineBasis& basis, std::span<const double> coefficients);

/// Noise model: the standard deviation of a reading is a fixed share of the reading, or of the gauge's full
/// scale (then it is constant over the record).
enum class Noise { of_reading, of_full_scale };

struct Posterior;

/// Smoothing spline through noisy readings y_i at times t_i: quintic B-splines s(t) that minimise
///   sum w_i (y_i - s(t_i))^2 + lambda int v s'''(x)^2 dx                                             (G.30)
/// Here x is the time scaled to [0, 1], and y is scaled to a largest reading of 1. The weight is
/// w_i = 1/(mean of readings near i)^2 or, for noise of full scale, 1. A first fit with v = 1 finds where the
/// curve bends. A second fit uses v = (r/max r + 0.001)^(-1/2), where r is the mean of s'''^2 around x.
///
/// lambda is the most likely one of a Gaussian process with this penalty (Wahba, Ann. Stat. 13, 1985,
/// 1378-1402), on a grid of ten values a decade.                                                      (G.31)
/// The bands come from its posterior (Wahba, J. R. Stat. Soc. B 45, 1983, 133-150).                   (G.32)
class SmoothingSpline {
 public:
  /// Fewest readings that the constructor accepts.
  static constexpr std::size_t kFewestReadings = 20;
  /// Most intervals between breakpoints. An interval holds four readings or, in short records, two.
  static constexpr std::size_t kMostIntervals = 320;

  /// Fits the spline to `readings` at `times` [s], one reading per time. `name` is used in errors.
  /// - Throws ReadingError (series "time") for times that do not rise strictly.
  /// - Throws ReadingError (series `name`) for a reading that is not finite or, with Noise::of_reading, is
  ///   not above 0 or is below a millionth of the largest.
  /// - Throws std::invalid_argument for fewer than kFewestReadings readings, sizes that differ, or no reading
  ///   above 0.
  SmoothingSpline(std::span<const double> times, std::span<const double> readings,
                  std::string_view name = "reading", Noise noise = Noise::of_reading);
  ~SmoothingSpline();
  SmoothingSpline(SmoothingSpline&&) noexcept;

  double smoothing() const;           // lambda, dimensionless
  double degrees_of_freedom() const;  // [-] trace of the smoother
  /// Standard deviation of a reading [-] from the weighted residuals, relative to the reading or, for noise
  /// of full scale, to the largest reading.
  double noise() const;

  /// Coefficients, in the unit of the readings.
  std::span<const double> coefficients() const { return coefficients_; }
  /// Basis at `time` [s], clamped to the record. Throws std::invalid_argument unless `time` is finite. Not
  /// thread-safe.
  SplineBasis basis(double time) const;
  /// Mean square of s''' around `time` [s], over the width that the spline resolves. Throws
  /// std::invalid_argument unless `time` is finite.
  double roughness(double time) const;
  /// Posterior standard deviations of value and slope (G.32).
  SplinePoint deviation(const SplineBasis& basis) const;
  /// Draws coefficients from the posterior. lambda is drawn first and divided by `undersmoothing`; the spline
  /// is then drawn from the posterior of that lambda. `normals` are independent standard normal numbers, one
  /// more than coefficients(). Throws std::invalid_argument for another number of them, or one that is not
  /// finite.
  void draw(std::span<const double> normals, double undersmoothing, std::span<double> coefficients) const;

 private:
  struct Workspace;
  void fit(std::span<const double> times, std::span<const double> readings, Noise noise);
  double residual(std::span<const double> times, std::span<const double> readings,
                  std::span<const double> weights, std::span<const double> coefficients) const;

  double begin_;
  double length_;  // [s]
  std::vector<double> coefficients_;
  std::vector<double> roughness_;  // by intervals
  std::unique_ptr<Posterior> posterior_;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace gas
