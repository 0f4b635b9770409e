// SPDX-License-Identifier: Apache-2.0
#include "substepper.hpp"

#include <algorithm>
#include <cmath>

#include "first_gas.hpp"
#include "limits.hpp"
#include "rate_slopes.hpp"
#include "require.hpp"

namespace gas {
namespace {

// An explicit sub-step is at most so many times as long as the gas takes to relax: at 2.5 trials already
// fail.
constexpr double kStiff = 1.5;
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
      watch_(boundary, options.relative_tolerance),
      control_(options, options.method == Method::rosenbrock_4 ? 4.0 : 5.0),
      explicit_(make_explicit(options.method, boundary.slots())),
      implicit_(make_rodas(boundary.slots())),
      system_{ledger, Balance(boundary), {}, Vector(boundary.slots().species + 1)},
      begin_{0.0, Vector(boundary.slots().size()), {}, 0.0},
      trial_{begin_.rate, begin_.rate, begin_.rate} {}

void Substepper::begin_step(double temperature) {
  system_.effort = {};
  moments_ = {};
  system_.balance.begin_step(temperature);
}

/// Where flow sets in at p_a it grows as the root of the time.
Clock Substepper::suitable_clock(double b) const {
  const Moment& now = begin_.moment;
  if (!watch_.is_onset(now)) return {};
  const double left = b - begin_.t, since = std::max(0.0, now.overpressure / now.growth);
  // Where the flow balances its feed before the tolerance tells, what sets in is no matter.
  if (since >= left || !control_.tells(system_.balance, balanced_overpressure(system_.balance))) return {};
  return {true, begin_.t - std::max(since, kRootBegin * left)};
}

void Substepper::set_clock(const Clock& clock) {
  const auto slope = [&](const Clock& its) { return its.slope(its.position(begin_.t)); };
  const double slower = slope(clock) / slope(system_.clock);
  for (double& rate : begin_.rate) rate *= slower;
  system_.clock = clock;
}

void Substepper::start(double t, double b) {
  begin_.t = t;
  system_.clock = {};
  system_.valid = true;
  system_.rates_of(system_.gas = system_.ledger.gas(), begin_.rate, t);
  if (!system_.valid) control_.fail(system_, t, b - t, false);
  begin_.moment = watch_.moment(system_.balance);
  set_relaxation(kInfinity);
  set_clock(suitable_clock(b));
}

/// Before a sub-step of at most `length` [s]: where that is far from stiff, a bound of it does.
void Substepper::set_relaxation(double length) {
  begin_.relaxation = relaxation(system_.balance, control_.may_switch() ? kStiff / length : 0.0);
}

Stretch Substepper::reach(const Proposal& next, double b) const {
  const double share = control_.is_ending(system_.balance, begin_.moment) ? 1.0 : kTowardsAmbient;
  double length = std::min(control_.longest(system_.balance, begin_.relaxation), next.landing);
  if (!control_.is_fixed())
    length = std::min({length, next.length, share * watch_.until_ambient(begin_.moment)});
  return {system_.clock, begin_.t, std::min(begin_.t + length, b)};
}

/// Makes a trial of flow that is about to end at p_a end on it, if it ends beyond.
void Substepper::stop_at_ambient(double x) {
  const double from = begin_.moment.overpressure, to = system_.balance.gas().overpressure;
  if (!(from * to < 0.0) || system_.balance.closed_growth() != 0.0) return;
  for (double& amount : trial_.end) amount *= from / (from - to);
  system_.rates(trial_.end, trial_.end_rate, x);
}

/// One trial; the balance is left at its end. Its error over the tolerance, infinite if any stage met no gas.
double Substepper::try_step(const Stretch& trial, bool stiff) {
  const double t = trial.begin, end_x = trial.x + trial.h, length = trial.end - t;
  control_.require_stable(system_.balance, length, begin_.relaxation);
  if (++system_.effort.attempts > options_.maximum_steps || !(trial.h > 0.0))
    control_.fail(system_, t, length, system_.valid);
  system_.valid = true;
  if (stiff) system_.balance.locate(system_.ledger.gas(), t);  // a good guess of the temperature
  (stiff ? implicit_ : explicit_)->step(system_, begin_.rate, trial.x, trial.h, !control_.is_fixed(), trial_);
  trial_.reversed = system_.valid ? system_.ledger.stop_reversed(trial_.end, trial_.error) : 0.0;
  if (trial_.reversed > 0.0) system_.rates(trial_.end, trial_.end_rate, end_x);
  if (system_.valid && control_.is_ending(system_.balance, begin_.moment)) stop_at_ambient(end_x);
  if (!system_.valid && control_.is_fixed()) control_.fail(system_, t, length, false);
  return system_.valid ? control_.scaled_error(system_, trial_.error, system_.gas) : kInfinity;
}

/// What to try in place of a trial whose error is small: the other method where it took flow the wrong way, a
/// shorter one where it passes what it has to end on. None: the trial stands.
std::optional<Substepper::Proposal> Substepper::again(const Proposal& tried, const Stretch& trial,
                                                      const Moment& end) const {
  const Balance& balance = system_.balance;
  const Moment& begin = begin_.moment;
  const bool fixed = control_.is_fixed(), on_ambient = watch_.is_on_ambient(begin);
  const double length = trial.end - trial.begin;
  // Stopped where it turned, flow would stay there; at p_a it is rounding that turns it.
  const bool turns =
      fixed ? trial_.reversed > kReversed * balance.gas().mass : trial_.reversed > 0.0 && !on_ambient;
  if (turns || (!options_.unsafe_step && watch_.crosses_against_flow(begin, end, length))) {
    if (fixed) {
      if (turns || on_ambient || begin.growth * begin.flow > 0.0)
        control_.fail_fixed(trial.begin,
                            "is too long for the balance near ambient pressure: flow through the openings "
                            "takes p past p_a, where it would turn, or the wrong way");
      // What only runs out, or in, ends there.
      const double share = begin.overpressure / (begin.overpressure - end.overpressure);
      return Proposal{tried.length, trial.time(share) - trial.begin, tried.stiff};
    }
    const bool other = !tried.stiff && control_.may_switch();
    return Proposal{other ? length : kCrossingFactor * length, kInfinity, tried.stiff || other};
  }
  if (!trial.clock.root && !tried.stiff) control_.require_motion(balance, begin, end, length);
  const auto share = watch_.landing(trial, begin, end, tried.landing < kInfinity);
  if (!share) return {};
  const double landing = std::max(trial.time(*share), std::nextafter(trial.begin, kInfinity));
  if (!(landing < trial.end)) return {};
  return Proposal{tried.length, landing - trial.begin, tried.stiff};
}

/// Books the trial; the next sub-step, of about `after` [s], begins at its end.
void Substepper::accept(const Stretch& trial, const Moment& end, bool landed, double after, double b) {
  if (const auto share = watch_.switches(trial, begin_.moment, end))
    moments_.sonic_switch = trial.time(*share);
  if (const auto share = watch_.equalises(begin_.moment, end)) moments_.equalisation = trial.time(*share);
  system_.ledger.accept(trial_.end, trial.end);
  ++system_.effort.accepted;
  begin_.t = trial.end;
  begin_.rate.swap(trial_.end_rate);
  begin_.moment = end;
  set_relaxation(after);
  const bool short_since_onset = trial.end - trial.begin <= kRootShare * (trial.end - trial.clock.origin);
  if (landed && watch_.is_on_ambient(end))
    set_clock(suitable_clock(b));
  else if (trial.clock.root && ((short_since_onset && !control_.is_fixed()) || !watch_.is_onset(end)))
    set_clock({});
}

double Substepper::integrate(double a, double b, const TriggerState& triggers) {
  const Balance& balance = system_.balance;
  const ControlVolumeModel& model = balance.boundary().model();
  start(a, b);
  if (balance.gas().mass == 0.0 && model.heat_loss.conductance > 0.0) {
    const double filled = fill_first(system_, options_, trial_.end, a, b);
    if (filled > a) start(filled, b);
  }
  Proposal next{control_.first_step(balance)};
  while (begin_.t < b) {
    const Stretch trial = reach(next, b);
    next.stiff = next.stiff || options_.method == Method::rosenbrock_4 ||
                 (control_.may_switch() && (trial.end - trial.begin) * begin_.relaxation > kStiff);
    const double error = try_step(trial, next.stiff);
    const double factor = control_.factor(error, (next.stiff ? implicit_ : explicit_)->error_power());
    if (error > 1.0) {
      next = {trial.time(factor) - trial.begin, kInfinity, next.stiff};
      continue;
    }
    const Moment end = watch_.moment(balance);
    if (const auto repeated = again(next, trial, end)) {
      next = *repeated;
      continue;
    }
    if (balance.gas().beyond)  // it starts on the last knot, where trials end that pass it
      throw DomainError(beyond_text(model) + ", at t = " + to_text(begin_.t) + " s");
    const bool landed = next.landing < kInfinity;
    const double fits = trial.time(1.0 + watch_.time_kept(begin_.moment, end) * factor) - trial.end;
    const double kept = landed ? std::max(fits, next.length) : fits;
    accept(trial, end, landed, kept, b);
    if (network_.switches(triggers, end.overpressure, model.ambient.pressure)) break;
    // Just after an onset the slope changes within the time since it: a stiff sub-step may not keep its
    // length.
    next = {kept * begin_.relaxation > kStiff ? fits : kept};
  }
  return begin_.t;
}

}  // namespace gas
