// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

namespace gas {

/// Pressure of the tank before firing: the mean of the readings that are flat at the start of the record.
///
/// How many are flat, the readings decide. For each number n of them the pressure is c, then
/// c + a (t - t_n) + b (t - t_n)^2, up to where it has risen by six standard deviations of a reading. The
/// posterior of c is the mixture over n, weighted by 1/n and by the evidence (linear Gaussian model, flat
/// prior of c): a record often starts at firing, which one number among many would hide. The smoothing spline
/// does not serve: smoothing rounds the kink at the onset, and starts too high.   (G.38)
class InitialPressure {
 public:
  /// `deviation` [Pa] > 0 is that of a reading at the start. Preconditions: times that rise, three readings
  /// or more.
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
