// SPDX-License-Identifier: Apache-2.0
#include "substepper.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "near.hpp"

namespace gas {
namespace {

// The flux has a continuous slope across the sonic switch: an error of its place enters squared.
constexpr double kSonicNear = 1e-8;
constexpr double kCrossingFactor = 0.25;
// Where flow ends as the root of time errors fall as h^1.5: (2^4 - 1)/(2^1.5 - 1) times what doubling of
// order 4 makes of them; more than of order 1, and than an embedded pair's.
constexpr double kRootError = 8.2;
// The first step's error constant is of the order kFirstStep^-error_power: a guess, only speed depends on it.
constexpr double kFirstStep = 5.0;

}  // namespace

Substepper::Substepper(const FlowBalance& balance, std::vector<double> levels,
                       const IntegratorOptions& options)
    : options_(options),
      levels_(std::move(levels)),
      sonic_near_(kSonicNear * balance.ambient_pressure()),
      stepper_(make_stepper(options.method, balance)),
      first_step_share_(kFirstStep * std::pow(options.relative_tolerance, 1.0 / stepper_->error_power())),
      zero_(balance.unknowns(), 0.0),
      begin_rate_(zero_),
      hold_rate_(zero_) {
  trial_ = {zero_, zero_, zero_};
}

void Substepper::begin_step() {
  attempts_ = accepted_ = evaluations_ = 0;
  band_is_known_ = false;
  level_.reset();
}

void Substepper::count_attempt(const Rates& rates, double x, double h) {
  if (++attempts_ > options_.maximum_steps || !(x + h > x)) fail(rates, x, h);
}

/// One trial; `balance` is left at its end. False if any stage met no valid gas.
bool Substepper::try_step(Rates& rates, double x, double h) {
  count_attempt(rates, x, h);
  rates.valid = true;
  rates.depleted.reset();
  h = (x + h) - x;  // what flows in until then, exactly
  stepper_->step(rates, zero_, begin_rate_, x, h, options_.fixed_step == 0.0, trial_);
  if (!rates.valid) rates.balance.invalidate();
  return rates.valid;
}

/// Error of mass and of thermal energy (what an error of a mass takes along at its own h is no error of
/// temperature), over the tolerance.
double Substepper::scaled_error(const FlowBalance& balance) const {
  const auto& point = balance.point();
  if (!point.valid) return std::numeric_limits<double>::infinity();
  if (options_.fixed_step > 0.0) return 0.0;
  const double work = trial_.error[balance.work_slot()];
  double energy = balance.energy_change(trial_.error) + work, largest = 0.0;
  for (std::size_t k = 0; k < balance.species(); ++k) {
    const double change = balance.species_change(trial_.error, k);
    if (change != 0.0) energy -= balance.species_enthalpy(k) * change;
    largest = std::max(largest, std::abs(change));
  }
  const double energy_error = std::abs(energy) + std::abs(work);
  if (largest == 0.0 && energy_error == 0.0) return 0.0;
  return std::max(largest / point.mass, energy_error / point.thermal_energy) / options_.relative_tolerance;
}

void Substepper::enter_band(FlowBalance& balance) const {
  const double front = levels_.front(), back = levels_.back();
  balance.enter_band(band_ == 0                ? front - std::abs(front) - 1.0
                     : band_ == levels_.size() ? back + std::abs(back) + 1.0
                                               : 0.5 * (levels_[band_ - 1] + levels_[band_]));
}

/// Overpressures [Pa] closer to zero than this are there. Where the volume follows p, the gas changes by
/// `compliance` times as much as p.
double Substepper::ambient_near(const FlowBalance& balance) const {
  return kNear * balance.ambient_pressure() / balance.point().compliance;
}

/// The same of a level: not below the rounding of a few operations on it.
double Substepper::level_near(const FlowBalance& balance, std::size_t i) const {
  constexpr double kRoundOff = 8.0 * std::numeric_limits<double>::epsilon();
  return std::max(ambient_near(balance) + kNear * std::max(0.0, levels_[i]) / balance.point().compliance,
                  kRoundOff * std::abs(levels_[i]));
}

/// The band of p, on a level that above or below it.
std::size_t Substepper::band_above(const FlowBalance& balance) const {
  std::size_t band = 0;
  while (band < levels_.size() && balance.pressure_excess() >= levels_[band] - level_near(balance, band))
    ++band;
  return band;
}

std::size_t Substepper::band_below(const FlowBalance& balance) const {
  std::size_t band = levels_.size();
  while (band > 0 && balance.pressure_excess() <= levels_[band - 1] + level_near(balance, band - 1)) --band;
  return band;
}

/// The band of levels that p is in, or, on a level, the one it is going to: the flows do not jump there.
void Substepper::find_band(FlowBalance& balance, double t) {
  if (levels_.empty()) return;
  if (!band_is_known_) {
    band_ = band_above(balance);
    enter_band(balance);
    balance.fill_rates(begin_rate_, t);
    if (balance.pressure_rate(t) <= 0.0) band_ = band_below(balance);
  }
  band_is_known_ = false;
  enter_band(balance);
  require_volume(balance, t);
  balance.locate(zero_, t);
}

/// Regime at time t, the begin of a sub-step. At p = p_a gas flows only if something would change p in [t,
/// b].
void Substepper::start_regime(FlowBalance& balance, double t, double b) {
  balance.set_regime(Regime::kClosed);
  balance.locate(zero_, t);
  const double excess = balance.pressure_excess();
  const bool on = std::abs(excess) <= ambient_near(balance) && balance.ambient_pressure() > 0.0;
  const double begin = balance.closed_pressure_growth(t);
  const double side = !on ? excess : begin != 0.0 ? begin : balance.closed_pressure_growth(b);
  if (balance.is_open() && side > 0.0)
    balance.set_regime(balance.sonic_excess() >= 0.0 ? Regime::kOutSonic : Regime::kOut);
  else if (balance.has_backflow() && side < 0.0)
    balance.set_regime(balance.back_sonic_excess() < 0.0 ? Regime::kBackSonic : Regime::kBack);
  find_band(balance, t);
  start_hold(balance, t, b, 1.0);
}

/// Enters what lies behind the event; true if the caller has to bring knots and triggers up to date.
bool Substepper::pass_event(FlowBalance& balance) {
  if (event_ != Event::kLevelAbove && event_ != Event::kLevelBelow) {
    balance.set_regime(next_regime_);
    return false;
  }
  level_ = levels_[event_ == Event::kLevelAbove ? band_ : band_ - 1];
  event_ == Event::kLevelAbove ? ++band_ : --band_;
  band_is_known_ = true;
  return true;
}

double Substepper::integrate(FlowBalance& balance, double a, double b) {
  Rates rates{balance};
  event_ = Event::kNone;
  start_regime(balance, a, b);
  start_variable(rates, a, b);
  double t = a;
  if (balance.point().mass == 0.0 && balance.has_walls() && (t = fill_first(rates, a, b)) > a) {
    start_regime(balance, t, b);
    start_variable(rates, t, b);
  }
  double x = rates.position(t);
  const double first = first_step(balance, t);
  double h = rates.position(first < b - t ? t + first : b) - x;
  Start start = start_values(balance, t);
  double longest = longest_step(rates, t);
  while (t < b) {
    const double x_end = rates.position(b);
    h = options_.fixed_step > 0.0 ? longest : std::min(h, longest);
    const bool last = h >= x_end - x;
    if (last) h = x_end - x;
    require_stable(rates, x, h);
    if (!try_step(rates, x, h) && options_.fixed_step > 0.0) fail(rates, x, h);
    const double error = scaled_error(balance);
    if (error <= 1.0 && !rates.root) settle_trial(balance, x + h, h);
    const bool crosses = error <= 1.0 && crosses_against_flow(balance, rates.time(x + h), start);
    if (options_.fixed_step > 0.0 && (crosses || flows_backwards(balance))) fail_crossing(t);
    if (stands_still(rates, x, h, start)) fail_standing(t);
    if (error > 1.0 || crosses || hold_turns_back(balance, h, start) ||
        lags_behind_balance(balance, t, rates.time(x + h), start)) {
      h *= error > 1.0 ? step_factor(error) : kCrossingFactor;
      continue;
    }
    const double length = end_at_events(rates, x, h, start);
    if (const double shorter = ends_as_root() && length > 0.0 ? kRootError * scaled_error(balance) : 0.0;
        shorter > 1.0) {
      h = length * step_factor(shorter);
      continue;
    }
    if (length > 0.0) {
      t = last && length == h ? b : rates.time(x + length);
      balance.accept(trial_.end, t);
      begin_rate_.swap(trial_.end_rate);
      ++accepted_;
    }
    if (t == b && event_ == Event::kNone) break;
    const double factor = step_factor(error), next = rates.time(x + factor * h) - rates.time(x);
    x += length;
    h *= factor;
    if (event_ != Event::kNone) {
      if (length == 0.0) balance.locate(zero_, t);
      if (pass_event(balance)) break;
      start_variable(rates, t, b);
      x = rates.position(t);
      h = rates.position(t + next) - x;
    }
    if (may_leave_root(rates, t) && rates.leave_root(t, x, h)) rates.fill(begin_rate_, x);
    start = start_values(balance, t);
    longest = longest_step(rates, t);
  }
  evaluations_ += rates.evaluations;
  return t;
}

}  // namespace gas
