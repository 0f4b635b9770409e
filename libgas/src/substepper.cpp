// SPDX-License-Identifier: Apache-2.0
#include "substepper.hpp"

#include <algorithm>
#include <cmath>

#include "first_gas.hpp"
#include "infinity.hpp"
#include "require.hpp"

namespace gas {
namespace {

// An explicit sub-step is at most as long as the gas takes to relax: at 2.5 of it trials already fail.
constexpr double kStiff = 1.0;
// Of the time in which flow that ends at p_a does so: a sixteenth of p - p_a is left then.
constexpr double kTowardsAmbient = 0.75;
// Of the gas, what may flow the wrong way by rounding: a hundred times what a hundred operations make.
constexpr double kReversed = 1e-12;
// After a trial that took p through p_a against its flow.
constexpr double kCrossingFactor = 0.5;
// Steps up to a sixteenth of the time since the onset: each further term of sqrt(t) is less than a sixteenth
// of the last.
constexpr double kRootShare = 1.0 / 16.0;
// The root's clock starts so much, of the time ahead, before the onset: at its origin all rates are zero.
constexpr double kRootBegin = 1e-12;

}  // namespace

Substepper::Substepper(const Boundary& boundary, Ledger& ledger, const TriggerNetwork& network,
                       const IntegratorOptions& options)
    : options_(options),
      network_(network),
      balance_(boundary),
      system_{ledger, balance_, {}, Vector(boundary.slots().species + 1)},
      watch_(boundary, options.relative_tolerance),
      control_(options, options.method == Method::kRosenbrock4 ? 4.0 : 5.0),
      explicit_(make_explicit(options.method, boundary.slots())),
      implicit_(make_rodas(boundary.slots())),
      begin_rate_(boundary.slots().size()) {
  trial_ = {begin_rate_, begin_rate_, begin_rate_};
}

void Substepper::begin_step(const ControlVolumeState& state) {
  attempts_ = accepted_ = system_.evaluations = 0;
  moments_ = {};
  balance_.begin_step(state);
}

/// Whether flow that something feeds lets p grow at more than half of the rate that it would have without.
bool Substepper::is_onset() const {
  const bool out = begin_.growth > 0.0 && (begin_.outflow > 0.0 || watch_.is_on_ambient(begin_)) &&
                   balance_.boundary().is_open();
  const bool in = begin_.growth < 0.0 && (begin_.backflow > 0.0 || watch_.is_on_ambient(begin_)) &&
                  balance_.boundary().has_backflow();
  return (out || in) && balance_.pressure_rate() / begin_.growth >= 0.5;
}

/// The clock of a sub-step from t: where flow sets in at p_a it grows as the root of the time.
void Substepper::start_clock(double t, double b) {
  const double since = is_onset() ? std::max(0.0, begin_.overpressure / begin_.growth) : kInfinity;
  system_.clock = {};
  // Where the flow balances its feed before the tolerance tells, what sets in is no matter.
  const bool matters = since < b - t && control_.tells(balance_, balance_.balanced_overpressure());
  if (matters) system_.clock = {true, t - std::max(since, kRootBegin * (b - t))};
  x_ = system_.clock.position(t);
  for (double& rate : begin_rate_) rate *= system_.clock.slope(x_);
  begin_.rate *= system_.clock.slope(x_);
}

void Substepper::start(double t, double b) {
  system_.clock = {};
  system_.valid = true;
  system_.rates_of(system_.gas = system_.ledger.gas(), begin_rate_, t);
  if (!system_.valid) control_.fail(system_, t, b - t, attempts_, false);
  begin_ = watch_.moment(balance_, 1.0);
  set_relaxation(kInfinity);
  start_clock(t, b);
}

/// Before a sub-step of at most `length` [s]: where that is far from stiff, a bound of it does.
void Substepper::set_relaxation(double length) {
  if (options_.method == Method::kDormandPrince5) {
    relaxation_ = control_.relaxation_bound(balance_);
    if (length * relaxation_ <= kStiff) return;
  }
  relaxation_ = balance_.relaxation(balance_.where_linear());
}

bool Substepper::is_stiff(double length) const {
  if (options_.method == Method::kRosenbrock4) return true;
  return options_.method == Method::kDormandPrince5 && !control_.is_fixed() && length * relaxation_ > kStiff;
}

/// One trial of `length` in x; the balance is left at its end. False if any stage met no gas.
bool Substepper::try_step(double length, bool stiff) {
  const double h = (x_ + length) - x_;  // what flows in until then, exactly
  const double t = system_.clock.time(x_);
  if (++attempts_ > options_.maximum_steps || !(h > 0.0) || !(system_.clock.time(x_ + h) > t))
    control_.fail(system_, t, system_.clock.time(x_ + length) - t, attempts_, system_.valid);
  system_.valid = true;
  system_.depleted.reset();
  trial_.reversed = 0.0;
  if (stiff) balance_.locate(system_.ledger.gas(), t);  // a good guess of the temperature
  (stiff ? implicit_ : explicit_)->step(system_, begin_rate_, x_, h, !control_.is_fixed(), trial_);
  if (stiff || control_.is_fixed() || !system_.valid) return system_.valid;
  trial_.reversed = system_.ledger.stop_reversed(trial_.end, trial_.error);
  if (trial_.reversed > 0.0) system_.rates(trial_.end, trial_.end_rate, x_ + h);
  return system_.valid;
}

double Substepper::fill_first(double t, double b) {
  const double end = gas::fill_first(system_, options_, trial_.end, t, b);
  if (end > t) ++accepted_;
  return end;
}

/// When the vents' flow switches and when p comes to p_a.
void Substepper::note_moments(const Moment& end, double t, double duration, bool landed) {
  if (landed && watch_.is_on_sonic(end)) moments_.sonic_switch = t + duration;
  if (const auto share = watch_.equalises(begin_, end)) moments_.equalisation = t + *share * duration;
}

/// Books the trial, which ends at x = `end` and time t; the next sub-step begins there.
void Substepper::accept(double end, double t, double b, bool landed, double after) {
  const Clock clock = system_.clock;
  const double duration = t - clock.time(x_), slope = clock.slope(end);
  system_.ledger.accept(trial_.end, t);
  begin_rate_.swap(trial_.end_rate);
  ++accepted_;
  set_relaxation(after);
  x_ = end;
  const bool leaves_root = clock.root && ((duration <= kRootShare * (t - clock.origin) && !control_.is_fixed()) || !is_onset());
  const bool sets_in = landed && watch_.is_on_ambient(begin_);
  if (!leaves_root && !sets_in) return;
  for (double& rate : begin_rate_) rate /= slope;
  begin_.rate /= slope;
  system_.clock = {};
  x_ = t;
  if (sets_in) start_clock(t, b);
}

double Substepper::integrate(double a, double b, const TriggerState& triggers) {
  double t = a;
  start(a, b);
  if (balance_.gas().mass == 0.0 && balance_.wall_conductance() > 0.0 && (t = fill_first(a, b)) > a) start(t, b);
  const double p_a = balance_.boundary().model().ambient.pressure;
  const double first = control_.first_step(balance_);
  double h = first < b - t ? system_.clock.position(t + first) - x_ : kInfinity;
  double landing = kInfinity;  // of a trial that has to end on what Watch found
  bool stiff = false;          // the trial is implicit
  while (t < b) {
    const Clock clock = system_.clock;
    const double left = clock.position(b) - x_, cap = control_.longest(balance_, relaxation_);
    const double longest = cap < b - t ? clock.position(t + cap) - x_ : kInfinity;
    double length = std::min({h, landing, kTowardsAmbient * watch_.until_ambient(begin_)});
    length = control_.is_fixed() ? std::min(longest, landing) : std::min(length, longest);
    const bool last = length >= left;
    if (last) length = left;
    const double end_time = last ? b : clock.time(x_ + length), duration = end_time - t;
    control_.require_stable(balance_, duration);
    stiff = stiff || is_stiff(duration);
    const bool found = try_step(length, stiff);
    if (!found && control_.is_fixed()) control_.fail(system_, t, duration, attempts_, false);
    const double error = found ? control_.scaled_error(system_, trial_.error, system_.gas) : kInfinity;
    const double next = length * control_.factor(error, (stiff ? implicit_ : explicit_)->error_power());
    if (error > 1.0) {
      h = next;
      landing = kInfinity;
      continue;
    }
    if (control_.is_fixed() && trial_.reversed > kReversed * balance_.gas().mass) control_.fail_crossing(t);
    const Moment end = watch_.moment(balance_, clock.slope(x_ + length));
    // Stopped where it turned, flow would stay there; at p_a it is rounding that turns it.
    const bool turns = trial_.reversed > 0.0 && !control_.is_fixed() && !watch_.is_on_ambient(begin_);
    if (turns || (!options_.unsafe_step && watch_.crosses_against_flow(begin_, end, duration))) {
      if (control_.is_fixed()) {  // what only runs out, or in, ends there
        const bool fed = begin_.outflow > 0.0 ? begin_.growth > 0.0 : begin_.growth < 0.0;
        if (fed || watch_.is_on_ambient(begin_)) control_.fail_crossing(t);
        landing = length * begin_.overpressure / (begin_.overpressure - end.overpressure);
        continue;
      }
      const bool repeats = !stiff && options_.method == Method::kDormandPrince5;
      h = repeats ? length : kCrossingFactor * length;
      stiff = stiff || repeats;
      landing = kInfinity;
      continue;
    }
    if (!clock.root && !stiff) control_.require_motion(balance_, begin_, end, duration);
    if (const auto share = watch_.landing(begin_, end, length)) {
      const double shorter = std::max(*share * length, std::nextafter(x_, kInfinity) - x_);
      if (shorter < length && clock.time(x_ + shorter) > t) {
        landing = shorter;
        continue;
      }
    }
    if (balance_.gas().beyond)  // it starts on the last knot, where trials end that pass it
      throw DomainError(beyond_text(*balance_.boundary().model().volume_of_overpressure) +
                        ", at t = " + to_text(t) + " s");
    note_moments(end, t, duration, landing < kInfinity);
    h = landing < kInfinity || last ? std::max(h, next) : next;
    const double after = clock.time(x_ + length + h) - end_time;
    begin_ = end;
    accept(x_ + length, end_time, b, landing < kInfinity, after);
    t = end_time;
    if (network_.switches(triggers, begin_.overpressure, p_a)) break;
    h = system_.clock.position(t + after) - x_;
    landing = kInfinity;
    stiff = false;
  }
  return t;
}

}  // namespace gas
