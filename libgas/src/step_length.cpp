// SPDX-License-Identifier: Apache-2.0
// Substepper: how long a sub-step may be.
#include <algorithm>
#include <cmath>

#include "infinity.hpp"
#include "substepper.hpp"

namespace gas {
namespace {

constexpr double kSafety = 0.9;
constexpr double kSmallestFactor = 0.05;
constexpr double kLargestFactor = 5.0;
// Of the limit of an explicit method: there |R| is 0 (Euler), 0.28 (Runge-Kutta 4), 0.20 (Dormand-Prince),
// and what p swings by near p_a, where its own rate has no bound, does not keep T going.
constexpr double kBelowLimit = 0.5;

}  // namespace

/// Step size factor from a scaled error.
double Substepper::step_factor(double error) const {
  if (!std::isfinite(error)) return kSmallestFactor;
  if (error <= 0.0) return kLargestFactor;
  return std::clamp(kSafety * std::pow(error, -1.0 / stepper_->error_power()), kSmallestFactor,
                    kLargestFactor);
}

/// A first step [s] from t, from how fast the gas changes; from none, as long as there is.
double Substepper::first_step(const FlowBalance& balance, double t) const {
  const auto& point = balance.point();
  if (point.mass == 0.0) return kInfinity;
  const double fed = std::abs(balance.closed_pressure_growth(t)) / (point.pressure * point.volume);
  const double left = (point.vent + point.fabric + point.back) / point.mass;
  return first_step_share_ / (fed + left);
}

/// The longest sub-step in x under error control. Past the limit of its method on walls, (G.16), it would
/// leave T to swing about theirs by the tolerance, for ever, and at p_a gas would be let out and in with it
/// that no balance exchanges.
double Substepper::longest_step(const Rates& rates, double x) const {
  const double longest = kBelowLimit * stepper_->stability_limit() / rates.balance.heat_rate();
  return longest < kInfinity ? rates.position(rates.time(x) + longest) - x : kInfinity;
}

}  // namespace gas
