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

// Longest explicit sub-step, in relaxation times of the gas. At 2.5 trials already fail.
constexpr double kStiff = 1.5;
// Share of the time until flow ends at p_a. After it a sixteenth of p - p_a is left.
constexpr double kTowardsAmbient = 0.75;
// Share of the gas that may flow the wrong way by rounding: a hundred times the rounding of a hundred
// operations.
constexpr double kReversed = 1e-12;
// Factor of the length after a trial that took p through p_a against its flow.
constexpr double kCrossingFactor = 0.5;
// Longest step, as a share of the time since the onset: each further term of sqrt(t) is less than a sixteenth
// of the one before.
constexpr double kRootShare = 1.0 / 16.0;
// Sub-steps that begin in the laminar range (G.22) reach this many times its width, if they leave it.
constexpr double kThroughLaminar = 2.0;
// The root's clock starts before the onset by this share of the time ahead, because all rates are zero at its
// origin.
constexpr double kRootBegin = 1e-12;

/// Longest sub-step after an onset [s], as what flows in the laminar range is missed by stages beyond it.
double through_laminar(const Balance& balance, const Moment& now) {
  const double laminar = laminar_overpressure(balance.boundary().model());
  if (!(std::abs(now.overpressure) < laminar) || std::abs(balanced_overpressure(balance)) < 10.0 * laminar)
    return kInfinity;
  return kThroughLaminar * laminar / std::abs(now.growth);
}

}  // namespace

Substepper::Substepper(const Boundary& boundary, Ledger& ledger, const TriggerNetwork& network,
                       const IntegratorOptions& options)
    : options_(options),
      may_switch_(options.method == Method::dormand_prince_5 && options.fixed_step == 0.0),
      network_(network),
      events_(boundary, options.relative_tolerance),
      control_(options),
      explicit_(make_explicit(options.method, boundary.slots())),
      implicit_(make_rodas(boundary.slots())),
      system_{ledger, Balance(boundary), {}, Vector(boundary.slots().species + 1)},
      begin_{0.0, 0.0, Vector(boundary.slots().size()), {}, 0.0},
      trial_{begin_.rate, begin_.rate, begin_.rate} {}

void Substepper::begin_step(double temperature) {
  system_.effort = {};
  moments_ = {};
  system_.balance.begin_step(temperature);
}

/// Chooses the clock of a sub-step: flow that sets in at p_a grows as the root of the time.
void Substepper::start_clock(double b) {
  const Moment& now = begin_.moment;
  const Balance& balance = system_.balance;
  const double since =
      events_.is_onset(balance, now) ? std::max(0.0, now.overpressure / now.growth) : kInfinity;
  system_.clock = {};
  // If the flow balances its feed within the tolerance of p_a, its onset does not matter.
  const bool matters = since < b - begin_.t && control_.tells(balance, balanced_overpressure(balance));
  if (matters) system_.clock = {true, begin_.t - std::max(since, kRootBegin * (b - begin_.t))};
  begin_.x = system_.clock.position(begin_.t);
  for (double& rate : begin_.rate) rate *= system_.clock.slope(begin_.x);
  begin_.moment.rate *= system_.clock.slope(begin_.x);
}

void Substepper::start(double t, double b) {
  begin_.t = t;
  system_.clock = {};
  system_.valid = true;
  system_.rates_of(system_.ledger.gas(), begin_.rate, t);
  if (!system_.valid) control_.fail(system_, t, b - t, false);
  begin_.moment = events_.moment(system_.balance, 1.0);
  set_relaxation(kInfinity);
  start_clock(b);
}

/// Sets the relaxation rate before a sub-step of at most `length` [s]. If that is far from stiff, a bound of
/// the rate is enough.
void Substepper::set_relaxation(double length) {
  begin_.relaxation = relaxation(system_.balance, may_switch_ ? kStiff / length : 0.0);
}

Substepper::Reach Substepper::reach(const Proposal& proposal, double b) const {
  const Clock& clock = system_.clock;
  const double left = clock.position(b) - begin_.x,
               cap = control_.longest(system_.balance, begin_.relaxation);
  const double longest = cap < b - begin_.t ? clock.position(begin_.t + cap) - begin_.x : kInfinity;
  const double share = control_.is_ending(system_.balance, begin_.moment) ? 1.0 : kTowardsAmbient;
  const double free = std::min(proposal.length, share * events_.until_ambient(begin_.moment));
  const double slow =
      clock.root ? clock.position(begin_.t + through_laminar(system_.balance, begin_.moment)) - begin_.x
                 : kInfinity;
  const double length =
      std::min({longest, proposal.landing, control_.is_fixed() ? kInfinity : std::min(free, slow)});
  return length >= left ? Reach{left, b} : Reach{length, clock.time(begin_.x + length)};
}

/// If flow is about to end at p_a, shortens a trial that would end beyond p_a to end on it.
void Substepper::stop_at_ambient(double x) {
  const double from = begin_.moment.overpressure, to = system_.balance.gas().overpressure;
  if (!(from * to < 0.0) || system_.balance.closed_growth() != 0.0) return;
  for (double& amount : trial_.end) amount *= from / (from - to);
  system_.rates(trial_.end, trial_.end_rate, x);
}

/// Makes one trial; the balance is then located at its end. Returns the error over the tolerance; infinity if
/// a stage had no valid gas.
double Substepper::try_step(const Reach& reach, bool stiff) {
  const double t = begin_.t, x = begin_.x, h = (x + reach.length) - x;  // what flows in until then, exactly
  control_.require_stable(system_.balance, reach.end - t, begin_.relaxation);
  if (++system_.effort.attempts > options_.maximum_steps || !(system_.clock.time(x + h) > t) ||
      (t == 0.0 && control_.is_too_short(system_.balance, t, reach.end - t)))
    control_.fail(system_, t, reach.end - t, system_.valid);
  system_.valid = true;
  if (stiff) system_.balance.locate(system_.ledger.gas(), t);  // a good guess of the temperature
  (stiff ? implicit_ : explicit_)->step(system_, begin_.rate, x, h, !control_.is_fixed(), trial_);
  trial_.reversed = system_.valid ? system_.ledger.stop_reversed(trial_.end, trial_.error) : 0.0;
  if (trial_.reversed > 0.0) system_.rates(trial_.end, trial_.end_rate, x + h);
  if (system_.valid && control_.is_ending(system_.balance, begin_.moment)) stop_at_ambient(x + h);
  if (!system_.valid && control_.is_fixed()) control_.fail(system_, t, reach.end - t, false);
  return system_.valid ? control_.scaled_error(system_, trial_.error, system_.gas) : kInfinity;
}

/// What to try instead of a trial with a small error: the other method if flow went the wrong way; a shorter
/// trial if it passed an event. Empty: the trial is accepted.
std::optional<Substepper::Proposal> Substepper::again(const Proposal& tried, const Reach& reach,
                                                      const Moment& end) const {
  const Balance& balance = system_.balance;
  const Moment& begin = begin_.moment;
  const bool fixed = control_.is_fixed(), on_ambient = events_.is_on_ambient(begin);
  const double duration = reach.end - begin_.t;
  if (fixed && trial_.reversed > kReversed * balance.gas().mass) control_.fail_crossing(balance);
  // Flow that was stopped where it turned would stay there. At p_a only rounding turns it.
  const bool turns = trial_.reversed > 0.0 && !fixed && !on_ambient;
  if (turns || (!options_.unsafe_step && events_.crosses_against_flow(begin, end, duration))) {
    if (fixed) {  // flow that is not fed ends there
      const bool fed = begin.growth * begin.flow > 0.0;
      const bool away = begin.overpressure * end.overpressure > 0.0;
      if (fed || on_ambient || away) control_.fail_crossing(balance);
      return Proposal{tried.length,
                      reach.length * begin.overpressure / (begin.overpressure - end.overpressure),
                      tried.stiff};
    }
    const bool other = !tried.stiff && may_switch_;
    return Proposal{other ? reach.length : kCrossingFactor * reach.length, kInfinity, tried.stiff || other};
  }
  if (!system_.clock.root && !tried.stiff) control_.require_motion(balance, begin, end, duration);
  const auto share = events_.landing(begin, end, reach.length, tried.landing < kInfinity);
  if (!share) return {};
  const double shorter = std::max(*share * reach.length, std::nextafter(begin_.x, kInfinity) - begin_.x);
  if (!(shorter < reach.length && system_.clock.time(begin_.x + shorter) > begin_.t)) return {};
  return Proposal{tried.length, shorter, tried.stiff};
}

/// Adds the trial to the ledger; the next sub-step, of about `after` [s], begins at its end.
void Substepper::accept(const Reach& reach, const Moment& end, bool landed, double after, double b) {
  const Clock clock = system_.clock;
  const double duration = reach.end - clock.time(begin_.x), slope = clock.slope(begin_.x + reach.length);
  const bool sets_in = landed && events_.is_on_ambient(end);
  const auto time = [&](double share) {
    return system_.balance.boundary().segment().begin + clock.time(begin_.x + share * reach.length);
  };
  if (const auto share = events_.switches(begin_.moment, end, reach.length))
    moments_.sonic_switch = time(*share);
  if (const auto share = events_.equalises(begin_.moment, end)) moments_.equalisation = time(*share);
  system_.ledger.accept(trial_.end, reach.end);
  ++system_.effort.accepted;
  begin_.t = reach.end;
  begin_.x += reach.length;
  begin_.rate.swap(trial_.end_rate);
  begin_.moment = end;
  set_relaxation(after);
  const bool leaves_root =
      clock.root && ((duration <= kRootShare * (reach.end - clock.origin) && !control_.is_fixed()) ||
                     !events_.is_onset(system_.balance, end));
  if (!leaves_root && !sets_in) return;
  for (double& rate : begin_.rate) rate /= slope;
  begin_.moment.rate /= slope;
  system_.clock = {};
  begin_.x = reach.end;
  if (sets_in) start_clock(b);
}

double Substepper::integrate(const TriggerState& triggers) {
  const Balance& balance = system_.balance;
  const double b = balance.boundary().segment().length;
  start(0.0, b);
  if (balance.gas().mass == 0.0 && balance.boundary().model().heat_loss.conductance > 0.0) {
    const double filled = fill_first(system_, options_, trial_.end, 0.0, b);
    if (filled > 0.0) start(filled, b);
  }
  const double first = control_.first_step(balance), p_a = balance.boundary().model().ambient.pressure;
  Proposal next{first < b - begin_.t ? system_.clock.position(begin_.t + first) - begin_.x : kInfinity};
  while (begin_.t < b) {
    const Reach trial = reach(next, b);
    next.stiff = next.stiff || options_.method == Method::rosenbrock_4 ||
                 (may_switch_ && (trial.end - begin_.t) * begin_.relaxation > kStiff);
    const double error = try_step(trial, next.stiff);
    const double fitting =
        trial.length * control_.factor(error, (next.stiff ? implicit_ : explicit_)->error_power());
    if (error > 1.0) {
      next = {fitting, kInfinity, next.stiff};
      continue;
    }
    const Clock& clock = system_.clock;
    const double end_x = begin_.x + trial.length;
    const Moment end = events_.moment(balance, clock.slope(end_x));
    if (const auto repeated = again(next, trial, end)) {
      next = *repeated;
      continue;
    }
    if (balance.gas().beyond) {  // the segment starts on the last knot: trials that pass it end there
      const double at = balance.boundary().segment().begin + begin_.t;
      throw DomainError(beyond_text(balance.boundary().model()) + ", at t = " + to_short_text(at) + " s", at);
    }
    const bool landed = next.landing < kInfinity;
    const double fits = clock.time(end_x + events_.time_kept(begin_.moment, end) * fitting) - trial.end;
    const double kept = landed ? std::max(fits, clock.time(end_x + next.length) - trial.end) : fits;
    accept(trial, end, landed, kept, b);
    if (network_.switches(triggers, end.overpressure, p_a)) break;
    // Just after an onset the slope changes as fast as time passes, so a stiff sub-step may not keep its
    // length.
    const double after = kept * begin_.relaxation > kStiff ? fits : kept;
    next = {system_.clock.position(begin_.t + after) - begin_.x};
  }
  return begin_.t;
}

}  // namespace gas
