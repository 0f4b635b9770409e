// SPDX-License-Identifier: Apache-2.0
// Substepper: why a sub-step cannot be taken, or has to be repeated.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "gas/error.hpp"
#include "pressure_volume.hpp"
#include "require.hpp"
#include "substepper.hpp"

namespace gas {
namespace {

// p left behind a balance, of what it went: a parabola that is followed exactly leaves twice as much.
constexpr double kMostLeft = 2.0;
// From where on that is asked, in overpressures of the begin: flow has twice the slope there.
constexpr double kFarther = 4.0;

// Of the gas, what may flow the wrong way by rounding: a hundred times what a hundred operations make.
constexpr double kReversed = 1e-12;

}  // namespace

/// What could be done about sub-steps of `length` [s], too many or too short, at the gas last located.
std::string Substepper::advice(const FlowBalance& balance, double length) const {
  const auto& point = balance.point();
  const double relaxation = balance.relaxation_rate() + balance.heat_rate();
  std::string text;
  if (relaxation > 0.0) text = "; it relaxes within " + to_text(1.0 / relaxation) + " s";
  if (length * relaxation > 0.1 * stepper_->stability_limit())
    text += "; Rosenbrock 4 (gas_method of a case) has no such limit";
  const double limit = rounding_limit(balance);
  if (length > 0.1 * limit)
    text += "; it passes through within " +
            to_text(point.mass / std::max(point.vent + point.fabric, point.back)) +
            " s, so that rounding takes sub-steps below " + to_text(limit) +
            " s; a looser tolerance (gas_tolerance of a case) is allowed";
  return text;
}

void Substepper::fail(const Rates& rates, double x, double h) const {
  FlowBalance& balance = rates.balance;
  const auto& point = balance.point();
  const Thermo& thermo = rates.balance.thermo();
  const bool fixed = options_.fixed_step > 0.0;
  const double length = h * rates.time_slope(x + 0.5 * h);
  const std::string where =
      "at t = " + to_text(rates.time(x)) + " s with a sub-step of " + to_text(length) + " s";
  // What a trial met there is no matter: events and rates need shorter sub-steps than there are.
  const double rounding = 2.0 * std::numeric_limits<double>::epsilon() * std::abs(rates.time(x));
  const bool too_short = !fixed && length <= rounding;
  if (rates.depleted && !too_short)
    throw DomainError("species " + thermo.species(*rates.depleted).name +
                      " runs out: more of it would leave than there is, " + where +
                      (fixed ? "; a shorter one (gas_step of a case), or none, is allowed" : ""));
  const auto leaves_range = [&] {
    throw DomainError("the gas leaves its temperature range, " + to_text(thermo.minimum_temperature()) +
                      " to " + to_text(thermo.maximum_temperature()) + " K, " + where);
  };
  const bool trial_has_gas = point.valid;
  if (!trial_has_gas && !too_short) leaves_range();
  Vector rate(zero_);
  balance.locate(zero_, rates.time(x));
  // Trials that step over an end of the range are repeated until they are too short: the gas is on it then.
  constexpr double kOnEnd = 1e-6;  // of T
  const double t = point.temperature;
  if (!trial_has_gas && (!point.valid || t <= (1.0 + kOnEnd) * thermo.minimum_temperature() ||
                         t >= (1.0 - kOnEnd) * thermo.maximum_temperature()))
    leaves_range();
  balance.fill_rates(rate, rates.time(x));
  const std::string gas =
      ", p = " + to_text(point.pressure) + " Pa and T = " + to_text(point.temperature) + " K";
  if (fixed)
    throw DomainError("a fixed sub-step of " + to_text(options_.fixed_step) + " s takes more than " +
                      std::to_string(options_.maximum_steps) + " sub-steps, " + where + gas +
                      "; a longer one (gas_step of a case), or none, is allowed");
  const std::string limit =
      too_short ? "; that is below the rounding of t, " + to_text(rounding) +
                      " s: a larger volume, smaller openings or a start nearer to t = 0 is allowed"
                : "";
  throw TooStiff("the gas is too stiff for the integrator: " + std::to_string(attempts_) +
                 (attempts_ == 1 ? " sub-step, " : " sub-steps, ") + where + gas + advice(balance, length) +
                 limit);
}

/// Whether an implicit trial away from p_a leaves p further from where its flows take it than p went: the
/// slope of flow with p is beyond bounds at p_a, and a matrix of it holds p there, and its error, whatever
/// flows in.
bool Substepper::lags_behind_balance(const FlowBalance& balance, double begin, double end,
                                     const Start& start) const {
  if (std::isfinite(stepper_->stability_limit()) || options_.fixed_step > 0.0 || !balance.point().valid ||
      balance.regime() == Regime::kClosed || balance.is_held())
    return false;
  const double excess = balance.pressure_excess(), from = start.place.excess;
  if (std::abs(excess) < kFarther * std::abs(from)) return false;
  const double rate = std::abs(balance.pressure_rate(end));
  const double left = rate / std::max(balance.relaxation_rate(), 1.0 / (end - begin));
  return left >
         kMostLeft * (std::abs(excess - from) + options_.relative_tolerance * balance.point().pressure);
}

/// Whether an explicit trial ends where flow does so at p_a, which may be as the root of time: the error up
/// to there can be greater than that of the trial beyond.
bool Substepper::ends_as_root() const {
  return event_ == Event::kAmbient && std::isfinite(stepper_->stability_limit());
}

/// Whether more flows the wrong way in the trial than its rounding.
bool Substepper::flows_backwards(const FlowBalance& balance) const {
  return trial_.reversed > kReversed * balance.point().mass;
}

/// Where no volume belongs to the band of p at t.
void Substepper::require_volume(const FlowBalance& balance, double t) const {
  if (balance.is_beyond_volume())
    throw DomainError(beyond_text(*balance.volume_curve()) + ", at t = " + to_text(t) + " s");
}

/// A fixed step past the limit of its method grows where inflow feeds what leaves, or walls or expansion draw
/// in what comes back; where gas only runs out or in, p = p_a ends it. Walls feed and take.
void Substepper::require_stable(const Rates& rates, double x, double h) const {
  const FlowBalance& balance = rates.balance;
  if (options_.fixed_step == 0.0 || options_.unsafe_step) return;
  const double t = rates.time(x), growth = balance.closed_pressure_growth(t);
  const bool fed = balance.point().back > 0.0 ? growth < 0.0 : growth > 0.0;
  const double rate = balance.heat_rate() + (fed ? balance.relaxation_rate() : 0.0);
  const double limit = stepper_->stability_limit();
  if (!(h * rates.time_slope(x) * rate > limit)) return;
  throw DomainError("the step " + to_text(options_.fixed_step) + " s is above the method's stability limit " +
                    to_text(limit / rate) + " s at t = " + to_text(t) + " s, where the gas relaxes within " +
                    to_text(1.0 / rate) +
                    " s; Rosenbrock 4 (gas_method of a case) has no such limit, and error control (no "
                    "gas_step) keeps to it");
}

/// Whether p, at the end of a fixed trial of an explicit method, is about where it was though its rate at
/// both ends would have moved it far: between it has turned, past the method's limit on a balance that it
/// misses.
bool Substepper::stands_still(const Rates& rates, double x, double h, const Start& start) const {
  constexpr double kStill = 0.01;  // of the motion by the lesser rate; at the limit itself it is none
  if (options_.fixed_step == 0.0 || options_.unsafe_step || rates.root ||
      std::isinf(stepper_->stability_limit()))
    return false;
  const FlowBalance& balance = rates.balance;
  const double end = rates.time(x + h), rate = balance.pressure_rate(end);
  if (!(start.rate * rate > 0.0)) return false;
  const double moved = std::min(std::abs(start.rate), std::abs(rate)) * (end - rates.time(x));
  return moved > options_.relative_tolerance * balance.point().pressure &&
         std::abs(balance.pressure_excess() - start.place.excess) < kStill * moved;
}

void Substepper::fail_standing(double t) const {
  throw DomainError(
      "the step " + to_text(options_.fixed_step) +
      " s is too long for the balance of flows at t = " + to_text(t) +
      " s: p stays where its rate would move it; a shorter one (gas_step of a case), or none, is "
      "allowed");
}

/// A fixed step that crosses so is above the limit of the balance that it has yet to reach.
void Substepper::fail_crossing(double t) const {
  throw DomainError("the step " + to_text(options_.fixed_step) +
                    " s is too long for the balance near ambient pressure at t = " + to_text(t) +
                    " s: flow through the openings takes p past p_a, where it would turn, or the wrong way; "
                    "a shorter one (gas_step of a case), or none, is allowed");
}

}  // namespace gas
