// SPDX-License-Identifier: Apache-2.0
// Substepper: how long a sub-step may be.
#include <algorithm>
#include <cmath>
#include <limits>

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
// The first fixed sub-step of flow from p_a: of what feeds it, what may leave at the overpressure that the
// feed alone makes in it; by how much the feed may grow; that overpressure, of p_a; and of the fixed one, its
// length at least.
constexpr double kOnsetRelief = 1.0, kOnsetGrowth = 2.0, kOnsetNear = 0.1, kOnsetLeast = 1e-6;

}  // namespace

/// Step size factor from a scaled error.
double Substepper::step_factor(double error) const {
  if (options_.fixed_step > 0.0) return 1.0;
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
  constexpr double kLeast = 8.0 * std::numeric_limits<double>::epsilon();  // a rounding's gas is none yet
  return std::max(first_step_share_ / (fed + left), kLeast * std::abs(t));
}

/// Whether flow that something feeds lets p grow at more than half of the rate that it would have without.
bool Substepper::is_onset(const FlowBalance& balance, double t) const {
  const double growth = balance.closed_pressure_growth(t);
  const bool fed =
      balance.regime() == Regime::kOut ? growth > 0.0 : balance.regime() == Regime::kBack && growth < 0.0;
  return fed && balance.pressure_rate(t) / growth >= 0.5 / balance.point().volume;
}

/// Whether what feeds the flow hardly grows in the first fixed sub-step; error control sees to that.
bool Substepper::is_steady(const FlowBalance& balance, double t, double b) const {
  if (options_.fixed_step == 0.0) return true;
  const double next = balance.closed_pressure_growth(std::min(b, t + onset_step_));
  return std::abs(next) <= kOnsetGrowth * std::abs(balance.closed_pressure_growth(t));
}

/// From p = p_a the flow starts as the square root of time: step in that root, counted from where the flow
/// would be zero, while less flows than half of what p would rest at. Fills the rates at t, where the gas has
/// been located.
void Substepper::start_variable(Rates& rates, double t, double b) {
  FlowBalance& balance = rates.balance;
  rates.root = false;
  rates.fill(begin_rate_, t);
  if (settle_start(balance, t, b)) rates.fill(begin_rate_, t);
  const double growth = balance.closed_pressure_growth(t), excess = std::abs(balance.pressure_excess());
  const double shift =
      excess <= ambient_near(balance) ? 0.0 : excess * balance.point().volume / std::abs(growth);
  const bool onset = is_onset(balance, t) && shift < b - t;
  if (options_.fixed_step > 0.0) start_fixed_steps(rates, t, b, onset);
  if (onset && is_steady(balance, t, b)) {
    rates.root = true;
    rates.origin = onset_begin_ = t - shift;
    rates.fill(begin_rate_, rates.position(t));
  }
}

/// Where flow sets in at p_a, the first of the fixed sub-steps is shorter, and none is longer than it has
/// lasted.
void Substepper::start_fixed_steps(Rates& rates, double t, double b, bool onset) {
  FlowBalance& balance = rates.balance;
  const bool flows = balance.regime() == Regime::kOut || balance.regime() == Regime::kBack;
  onset = onset || (flows && std::abs(balance.pressure_excess()) <= 2.0 * balance.hold_near());
  onset_begin_ = onset ? t : -kInfinity;
  onset_step_ = options_.fixed_step;
  if (!onset) return;
  const auto point = balance.point();
  const double growth = balance.closed_pressure_growth(t);
  const auto is_too_long = [&](double step) {
    const double later = balance.closed_pressure_growth(std::min(b, t + step));
    if (step > kOnsetLeast * options_.fixed_step && std::abs(later) > kOnsetGrowth * std::abs(growth))
      return true;
    const double overpressure = growth * step / point.volume, size = std::abs(overpressure);
    return size > balance.hold_near() &&
           (size > kOnsetNear * balance.ambient_pressure() || balance.relief(t, overpressure) > kOnsetRelief);
  };
  while (is_too_long(onset_step_)) onset_step_ *= 0.25;
  rates.fill(begin_rate_, t);
}

/// Error control leaves the root once its sub-steps are short in it; fixed ones do once p no longer grows as
/// at its onset: a balance is steady in t alone.
bool Substepper::may_leave_root(const Rates& rates, double t) const {
  return options_.fixed_step == 0.0 || !is_onset(rates.balance, t);
}

/// What passes through in a sub-step [s] of this length rounds to the tolerance of what is there.
double Substepper::rounding_limit(const FlowBalance& balance) const {
  constexpr double kRoundOff = 100.0 * std::numeric_limits<double>::epsilon();
  const auto& point = balance.point();
  const double passing = std::max(point.vent + point.fabric, point.back);
  return passing > 0.0 && point.mass > 0.0 ? options_.relative_tolerance * point.mass / (kRoundOff * passing)
                                           : kInfinity;
}

/// The longest sub-step from t in x; the fixed one. Under error control, past the limit of its method on
/// walls, (G.16), an explicit one would leave T to swing about theirs by the tolerance, for ever, and at p_a
/// gas would be let out and in with it that no balance exchanges.
double Substepper::longest_step(const Rates& rates, double t) const {
  double longest = rounding_limit(rates.balance);
  if (options_.fixed_step > 0.0)
    longest = std::min(options_.fixed_step, std::max(onset_step_, t - onset_begin_));
  else if (const double walls = rates.balance.heat_rate(); walls > 0.0)
    longest = std::min(longest, kBelowLimit * stepper_->stability_limit() / walls);
  return longest < kInfinity ? rates.position(t + longest) - rates.position(t) : kInfinity;
}

}  // namespace gas
