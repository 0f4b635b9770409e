// SPDX-License-Identifier: Apache-2.0
// Substepper: where a sub-step has to end, because p passes a switch of the regime or a level.
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "infinity.hpp"
#include "near.hpp"
#include "substepper.hpp"

namespace gas {
namespace {

// The share of a flow that holds p, which may be infinite, is cut to this where its zero is sought.
constexpr double kMostShare = 2.0;

bool is_out(Regime regime) {
  return regime == Regime::kOut || regime == Regime::kOutSonic;
}

bool is_back(Regime regime) {
  return regime == Regime::kBack || regime == Regime::kBackSonic;
}

}  // namespace

Substepper::Place Substepper::place(const FlowBalance& balance) const {
  return {balance.pressure_excess(), balance.sonic_excess(), balance.back_sonic_excess()};
}

Substepper::Start Substepper::start_values(const FlowBalance& balance, double t) const {
  return {place(balance), balance.pressure_rate(t), balance.point().share};
}

/// How far [Pa] the gas is from an event.
double Substepper::distance(const Place& at, Event event) const {
  switch (event) {
    case Event::kSonic:
      return at.sonic;
    case Event::kBackSonic:
      return at.back_sonic;
    case Event::kLevelAbove:
      return at.excess - levels_[band_];
    case Event::kLevelBelow:
      return at.excess - levels_[band_ - 1];
    default:
      return at.excess;
  }
}

/// Distances [Pa] to an event below this are none.
double Substepper::closeness(const FlowBalance& balance, Event event) const {
  if (event == Event::kSonic || event == Event::kBackSonic) return sonic_near_;
  if (event == Event::kLevelAbove) return level_near(balance, band_);
  return event == Event::kLevelBelow ? level_near(balance, band_ - 1) : ambient_near(balance);
}

/// The switch of the regime that the gas at time t, the end of a trial, has passed. Outflow alone never takes
/// p below p_a, nor backflow above: what is there by error of the method comes back.
Substepper::Event Substepper::passed_switch(const FlowBalance& balance, double t) const {
  const double excess = balance.pressure_excess(), near = ambient_near(balance);
  const auto passed = [](bool yes, Event event) { return yes ? event : Event::kNone; };
  switch (balance.regime()) {
    case Regime::kClosed:
      return passed((balance.is_open() && excess > near) || (balance.has_backflow() && excess < -near),
                    Event::kAmbient);
    case Regime::kOutSonic:
      return passed(balance.sonic_excess() < -sonic_near_, Event::kSonic);
    case Regime::kBackSonic:
      return passed(balance.back_sonic_excess() > sonic_near_, Event::kBackSonic);
    case Regime::kOut:
      if (balance.sonic_excess() > sonic_near_) return Event::kSonic;
      return passed(excess < -near && balance.closed_pressure_growth(t) <= 0.0, Event::kAmbient);
    case Regime::kBack:
      if (balance.back_sonic_excess() < -sonic_near_) return Event::kBackSonic;
      return passed(excess > near && balance.closed_pressure_growth(t) >= 0.0, Event::kAmbient);
    case Regime::kHeldOut:
    case Regime::kHeldBack:
      break;
  }
  return Event::kNone;
}

Substepper::Event Substepper::passed_level(const FlowBalance& balance) const {
  const double excess = balance.pressure_excess();
  if (band_ < levels_.size() && excess > levels_[band_] + level_near(balance, band_))
    return Event::kLevelAbove;
  if (band_ > 0 && excess < levels_[band_ - 1] - level_near(balance, band_ - 1)) return Event::kLevelBelow;
  return Event::kNone;
}

Regime Substepper::regime_after(const FlowBalance& balance, Event event, double t) const {
  const Regime now = balance.regime();
  if (event == Event::kSonic) return now == Regime::kOut ? Regime::kOutSonic : Regime::kOut;
  if (event == Event::kBackSonic) return now == Regime::kBack ? Regime::kBackSonic : Regime::kBack;
  const double growth = balance.closed_pressure_growth(t), excess = balance.pressure_excess();
  const bool up = now == Regime::kClosed ? excess > 0.0 : growth > 0.0;
  const bool down = now == Regime::kClosed ? excess < 0.0 : growth < 0.0;
  if (up && !is_out(now) && balance.is_open()) return Regime::kOut;
  return down && now != Regime::kBack && balance.has_backflow() ? Regime::kBack : Regime::kClosed;
}

/// Whether the trial that ends at t takes p through p_a by an error of the method, be it within its
/// tolerance: outflow that inflow feeds ends below p_a, backflow that something draws in ends above.
/// Accepted, it would be followed by flow the other way, and that by the next crossing: an exchange of gas
/// that no balance makes.
bool Substepper::crosses_against_flow(const FlowBalance& balance, double t, const Start& start) const {
  if (options_.unsafe_step) return false;
  const double excess = balance.pressure_excess(), growth = balance.closed_pressure_growth(t),
               near = ambient_near(balance);
  if (is_out(balance.regime())) return start.place.excess >= -near && excess < -near && growth > 0.0;
  return is_back(balance.regime()) && start.place.excess <= near && excess > near && growth < 0.0;
}

/// Whether p may turn, inside the trial that ends at t, beyond a switch or level. A parabola turns, beyond
/// the nearer end, within duration/4 times the sum of its end slopes, and gas that follows a balance within
/// the time in which it relaxes.
bool Substepper::may_turn_past_event(const FlowBalance& balance, double t, double duration,
                                     const Start& start) const {
  const double rate = balance.pressure_rate(t);
  if (start.rate * rate >= 0.0) return false;
  const bool peak = start.rate > 0.0;
  const double within = std::min(0.25 * duration, 1.0 / balance.relaxation_rate());
  const double reach = (peak ? within : -within) * (std::abs(start.rate) + std::abs(rate));
  const auto turn = [&](double from, double to) {
    return (peak ? std::max(from, to) : std::min(from, to)) + reach;
  };
  const double excess = turn(start.place.excess, balance.pressure_excess());
  const double sonic = turn(start.place.sonic, balance.sonic_excess());
  const double back_sonic = turn(start.place.back_sonic, balance.back_sonic_excess());
  if (band_ < levels_.size() && excess > levels_[band_]) return true;
  if (band_ > 0 && excess < levels_[band_ - 1]) return true;
  switch (balance.regime()) {
    case Regime::kClosed:
      return (balance.is_open() && excess > 0.0) || (balance.has_backflow() && excess < 0.0);
    case Regime::kOutSonic:
      return sonic < 0.0;
    case Regime::kOut:
      return sonic > 0.0;
    case Regime::kBackSonic:
      return back_sonic > 0.0;
    case Regime::kBack:
      return back_sonic < 0.0;
    default:
      break;  // held: p does not turn
  }
  return false;
}

/// Shortens the trial [x, x + h] to a zero of function(length), to `bits` bits; returns its length.
template <class Function>
double Substepper::end_at_zero(Rates& rates, double x, double h, double begin, double end, int bits,
                               Function function) {
  double length = h;
  const double shortest = std::nextafter(x, kInfinity) - x;
  const auto value_at_end = [&](double trial) {
    try_step(rates, x, length = std::max(trial, shortest));
    return function(length);
  };
  boost::uintmax_t iterations = 60;
  const boost::math::tools::eps_tolerance<double> close(static_cast<unsigned>(bits));
  const auto bracket = boost::math::tools::toms748_solve(value_at_end, 0.0, h, begin, end, close, iterations);
  if (const double last = std::max(bracket.second, shortest); length != last)
    try_step(rates, x, length = last);
  return length;
}

/// Shortens the trial to where p turns; 20 bits in time are 40 in p.
double Substepper::end_at_turn(Rates& rates, double x, double h, const Start& start) {
  const auto rate = [&](double length) { return rates.balance.pressure_rate(rates.time(x + length)); };
  const double end = rate(h);
  return start.rate * end >= 0.0 ? h : end_at_zero(rates, x, h, start.rate, end, 20, rate);
}

/// Shortens the trial to end at `event`, which it has passed. A switch that p starts on and leaves at once,
/// or has passed already, is made at the begin (length 0); one that it starts on, leaves and comes back to
/// lies beyond a turn, which ends the trial.
double Substepper::end_at(Event event, Rates& rates, double x, double h, const Start& start) {
  const double near = closeness(rates.balance, event);
  const auto value = [&](double) {
    const double d = distance(place(rates.balance), event);
    return std::abs(d) <= 0.5 * near ? 0.0 : d;
  };
  const double begin = distance(start.place, event), end = value(h);
  event_ = event;
  next_regime_ = regime_after(rates.balance, event, rates.time(x + h));
  if (std::abs(begin) > near && begin * end < 0.0) return end_at_zero(rates, x, h, begin, end, 50, value);
  if (std::abs(begin) > near || start.rate * end >= 0.0) return 0.0;
  event_ = Event::kNone;
  return end_at_turn(rates, x, h, start);
}

/// Ends the trial [x, x + h] where p is no longer held, or by flow the other way, if it gets there, and
/// returns its length. `turned`: it has just turned, and what it does at rest is rounding.
double Substepper::end_of_hold(Rates& rates, double x, double h, double start_share, bool turned) {
  FlowBalance& balance = rates.balance;
  const double end = balance.point().share;
  const double bound = end > 1.0 ? 1.0 : 0.0;
  const auto beyond = [&](double share) { return std::clamp(share, -kMostShare, kMostShare) - bound; };
  const double begin = beyond(start_share);
  const bool rests = turned && bound == 0.0 && begin < kShareNear;
  if (!(end >= 0.0 && end <= 1.0) && !rests) {
    event_ = Event::kHold;
    next_regime_ = regime_after_hold(balance, rates.time(x + h), bound > 0.0);
    if (std::abs(begin) < kShareNear || begin * (end - bound) > 0.0) return 0.0;
    const auto value = [&](double) { return beyond(balance.point().share); };
    h = end_at_zero(rates, x, h, begin, value(h), 40, value);
  }
  balance.settle(trial_.end, trial_.end_rate, rates.time(x + h), h);
  return h;
}

/// Shortens the trial to end at a switch or a level that it passes.
double Substepper::end_at_switches(Rates& rates, double x, double h, const Start& start) {
  const FlowBalance& balance = rates.balance;
  const auto end = [&] { return rates.time(x + h); };
  // First the turn: the end may have passed one event, and p before it another.
  if (may_turn_past_event(balance, end(), end() - rates.time(x), start)) h = end_at_turn(rates, x, h, start);
  if (const Event passed = passed_switch(balance, end()); passed != Event::kNone)
    h = end_at(passed, rates, x, h, start);
  if (const Event passed = passed_level(balance); h > 0.0 && passed != Event::kNone)
    h = end_at(passed, rates, x, h, start);
  return h;
}

/// If the accepted trial [x, x + h] passes a switch or a level, or comes to where p is held, ends it there
/// and sets event_. Returns its length; zero if it has to be repeated from its begin.
double Substepper::end_at_events(Rates& rates, double x, double h, const Start& start) {
  FlowBalance& balance = rates.balance;
  const bool turned = event_ == Event::kHold;
  event_ = Event::kNone;
  if (balance.is_held()) return end_of_hold(rates, x, h, start.share, turned);
  h = end_at_switches(rates, x, h, start);
  const Regime regime = balance.regime();
  const double t = rates.time(x + h);
  if (event_ == Event::kNone && regime != Regime::kClosed && start_hold(balance, t, t, 0.25)) {
    event_ = Event::kHold;
    next_regime_ = balance.regime();
    balance.set_regime(regime);
  }
  return h;
}

}  // namespace gas
