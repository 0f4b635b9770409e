// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

namespace gas {

/// Pressure of the tank before firing: the mean of the readings that are flat at the start of the record.
///
/// The number n of flat readings is not known. For each n the pressure is c, then
/// c + a (t - t_n) + b (t - t_n)^2, up to a rise of six standard deviations of a reading. The posterior of c
/// is the mixture over n, weighted by the evidence (linear Gaussian model, flat prior of c) and by 1/n,
/// because a record often starts at firing. The smoothing spline starts too high, because it rounds the kink
/// at the onset. (G.38)
class InitialPressure {
 public:
  /// `deviation` [Pa] > 0 is the standard deviation of a reading at the start. Preconditions: times that
  /// rise, three readings or more.
  InitialPressure(std::span<const double> times, std::span<const double> readings, double deviation);

  /// [Pa] posterior mean.
  double value() const { return value_; }
  /// [Pa] a draw of the posterior, from two independent standard normal numbers.
  double draw(double choice, double normal) const;

 private:
  /// Posterior for one number of flat readings.
  struct Share {
    double weight;           // [-] all sum to 1
    double mean, deviation;  // [Pa]
  };
  std::vector<Share> shares_;
  double value_ = 0.0;
};

}  // namespace gas
