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
/// The spline with these coefficients, at the time of the basis. std::invalid_argument if they are too few.
SplinePoint evaluate(const SplineBasis& basis, std::span<const double> coefficients);

/// What the standard deviation of a reading is a fixed share of: the reading itself, or the gauge's full
/// scale, so that it is the same over the record.
enum class Noise { of_reading, of_full_scale };

struct Modes;
/// Values of lambda and how likely the readings make them.
struct Lambdas {
  double best = 0.0;               // the likeliest value
  std::vector<double> values;      // those tried, rising
  std::vector<double> cumulative;  // probability up to each value
  /// The value below which lambda lies with this probability, 0 to 1.
  double quantile(double probability) const;
};

/// Smoothing spline through noisy readings y_i at times t_i: quintic B-splines s(t) that minimise
///   sum w_i (y_i - s(t_i))^2 + lambda int v s'''(x)^2 dx                                             (G.30)
/// with x the time scaled to [0, 1] and y scaled to a largest reading of 1; w_i = 1/(mean of readings near
/// i)^2 or, for noise of full scale, 1. A first fit with v = 1 finds where the curve bends; then
/// v = (r/max r + 0.001)^(-1/2), r its mean s'''^2 around x. lambda is the likeliest of a Gaussian process
/// with this penalty (Wahba, Ann. Stat. 13, 1985, 1378-1402), on a grid of ten values a decade.      (G.31)
/// Its posterior is the source of the bands (Wahba, J. R. Stat. Soc. B 45, 1983, 133-150).           (G.32)
class SmoothingSpline {
 public:
  /// The constructor refuses fewer.
  static constexpr std::size_t kFewestReadings = 20;
  /// At most this many intervals. One holds four readings or, in short records, two.
  static constexpr std::size_t kMostIntervals = 320;

  /// `name` is for errors: ReadingError (series "time" or `name`) for times that do not rise strictly or a
  /// reading that is not finite or, with noise of the reading, not above 0 and at least a millionth of the
  /// largest; std::invalid_argument for fewer than kFewestReadings or no reading above 0.
  SmoothingSpline(std::span<const double> times, std::span<const double> readings,
                  std::string_view name = "reading", Noise noise = Noise::of_reading);
  ~SmoothingSpline();
  SmoothingSpline(SmoothingSpline&&) noexcept;

  double smoothing() const { return smoothing_; }                    // lambda, dimensionless
  double degrees_of_freedom() const { return degrees_of_freedom_; }  // trace of the smoother
  /// Standard deviation of a reading as a fraction of it (of the largest), from the weighted residuals.
  double noise() const { return noise_; }

  /// Coefficients in the readings' unit.
  std::span<const double> coefficients() const { return coefficients_; }
  /// Basis at `time`, clamped to the record; std::invalid_argument unless finite. Not from two threads at
  /// once.
  SplineBasis basis(double time) const;
  /// Mean square of s''' around `time`, as wide as the spline resolves; std::invalid_argument unless finite.
  double roughness(double time) const;
  /// Standard deviations of value and slope in the posterior (G.32).
  SplinePoint deviation(const SplineBasis& basis) const;
  /// A draw of coefficients: lambda by its likelihood, over `undersmoothing`, then the spline from the
  /// posterior of that lambda. `normals`: independent standard normal numbers, one more than coefficients().
  /// std::invalid_argument for another number, or one that is not finite.
  void draw(std::span<const double> normals, double undersmoothing, std::span<double> coefficients) const;

 private:
  struct Workspace;
  void fit(std::span<const double> times, std::span<const double> readings, Noise noise);
  double residual(std::span<const double> times, std::span<const double> readings,
                  std::span<const double> weights, std::span<const double> coefficients) const;

  double begin_;
  double length_;  // [s]
  double smoothing_ = 0.0;
  double degrees_of_freedom_ = 0.0;
  double noise_ = 0.0;
  std::vector<double> coefficients_;
  double scale_ = 0.0;  // largest reading
  Lambdas lambdas_;
  std::unique_ptr<Modes> modes_;
  std::vector<double> amplitudes_;
  std::vector<double> roughness_;  // by intervals
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace gas
