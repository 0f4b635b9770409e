// SPDX-License-Identifier: Apache-2.0
#include "substepper.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "gas/error.hpp"
#include "require.hpp"

namespace gas {
namespace {

// Pressures closer to a switch than this times p_a are on it: some hundred roundings of p.
constexpr double kSwitchTolerance = 1e-12;
constexpr double kSafety = 0.9;
constexpr double kSmallestFactor = 0.2;
constexpr double kLargestFactor = 5.0;
constexpr int kEvaluationsPerStep = 6;

/// Step size factor from a scaled error; the error of the step grows as h^5.
double step_factor(double error) {
  if (!std::isfinite(error)) return kSmallestFactor;
  if (error <= 0.0) return kLargestFactor;
  return std::clamp(kSafety * std::pow(error, -0.2), kSmallestFactor, kLargestFactor);
}

}  // namespace

Substepper::Substepper(std::size_t unknowns, const IntegratorOptions& options)
    : options_(options), begin_rate_(unknowns), end_(unknowns), end_rate_(unknowns), error_(unknowns) {
  stepper_.adjust_size(end_);
}

void Substepper::begin_step() {
  attempts_ = accepted_ = evaluations_ = 0;
}

void Substepper::count_attempt(const FlowBalance& balance, double t, double h) {
  if (++attempts_ <= options_.maximum_steps && t + h > t) return;
  const auto& point = balance.point();
  const std::string where = "at t = " + to_text(t) + " s with p = " + to_text(point.pressure) +
                            " Pa, T = " + to_text(point.temperature) + " K and a sub-step of " + to_text(h) +
                            " s";
  if (!point.valid) throw DomainError("the gas leaves its temperature range, or none is left, " + where);
  throw DomainError("the gas is too stiff for the explicit integrator: " + std::to_string(attempts_) +
                    " sub-steps, " + where);
}

void Substepper::evaluate(FlowBalance& balance, const Vector& y, Vector& dydt, double t) {
  balance(y, dydt, t);
  ++evaluations_;
}

/// One trial; `balance` is left at its end, invalid if any stage was.
void Substepper::try_step(FlowBalance& balance, const Vector& y, double t, double h) {
  count_attempt(balance, t, h);
  bool valid = true;
  const auto rates = [&](const Vector& state, Vector& dydt, double time) {
    balance(state, dydt, time);
    valid = valid && balance.point().valid;
  };
  stepper_.do_step(rates, y, begin_rate_, t, end_, end_rate_, h, error_);
  evaluations_ += kEvaluationsPerStep;
  if (!valid) balance.invalidate();
}

/// Error of mass and of thermal energy (what an error of mass takes along at the mixture's h is no error of
/// temperature), over the tolerance.
double Substepper::scaled_error(const FlowBalance& balance) const {
  const auto& point = balance.point();
  if (!point.valid) return std::numeric_limits<double>::infinity();
  double mass_error = 0.0, largest = 0.0;
  for (std::size_t k = 0; k < balance.enthalpy_slot(); ++k) {
    mass_error += error_[k];
    largest = std::max(largest, std::abs(error_[k]));
  }
  const double energy_error =
      std::abs(error_[balance.enthalpy_slot()] - point.specific_enthalpy * mass_error) +
      std::abs(error_[balance.work_slot()]);
  if (largest == 0.0 && energy_error == 0.0) return 0.0;
  return std::max(largest / point.mass, energy_error / point.thermal_energy) / options_.relative_tolerance;
}

/// Regime at (y, t), and the rates in it. At p = p_a gas leaves only if something would raise p in [t, b].
void Substepper::start_regime(FlowBalance& balance, const Vector& y, double t, double b) {
  balance.set_regime(Regime::kClosed);
  evaluate(balance, y, begin_rate_, t);
  const double tolerance = kSwitchTolerance * balance.ambient_pressure();
  const double excess = balance.pressure_excess();
  if (!balance.is_open() || excess < -tolerance) return;
  const bool rises = balance.closed_pressure_growth(t) > 0.0 || balance.closed_pressure_growth(b) > 0.0;
  if (excess <= tolerance && balance.ambient_pressure() > 0.0 && !rises) return;
  balance.set_regime(balance.sonic_excess() >= 0.0 ? Regime::kChoked : Regime::kSubsonic);
  evaluate(balance, y, begin_rate_, t);
}

Substepper::Start Substepper::start_values(const FlowBalance& balance, double t) const {
  return {balance.pressure_excess(), balance.sonic_excess(), balance.pressure_rate(begin_rate_, t)};
}

/// Shortens the trial [t, t + h] to a zero of event(length), to `bits` bits; returns its length.
template <class Event>
double Substepper::end_at(FlowBalance& balance, const Vector& y, double t, double h, double begin_value,
                          double end_value, int bits, Event event) {
  double length = h;
  const auto value_at_end = [&](double trial) {
    try_step(balance, y, t, length = trial);
    return event(trial);
  };
  boost::uintmax_t iterations = 60;
  const boost::math::tools::eps_tolerance<double> close(bits);
  const auto bracket =
      boost::math::tools::toms748_solve(value_at_end, 0.0, h, begin_value, end_value, close, iterations);
  if (length != bracket.second) try_step(balance, y, t, length = bracket.second);
  return length;
}

/// The switch that the gas at time t, the end of a trial, has passed.
Substepper::Switch Substepper::passed_switch(const FlowBalance& balance, double t) const {
  const double tolerance = kSwitchTolerance * balance.ambient_pressure();
  const double excess = balance.pressure_excess(), sonic = balance.sonic_excess();
  switch (balance.regime()) {
    case Regime::kClosed:
      return balance.is_open() && excess > tolerance ? Switch::kAmbient : Switch::kNone;
    case Regime::kChoked:
      return sonic < -tolerance ? Switch::kSonic : Switch::kNone;
    case Regime::kSubsonic:
      if (sonic > tolerance) return Switch::kSonic;
      // Outflow alone never takes p below p_a: what is below by error of the method comes back.
      return excess < -tolerance && balance.closed_pressure_growth(t) <= 0.0 ? Switch::kAmbient
                                                                             : Switch::kNone;
  }
  return Switch::kNone;
}

/// Whether p may turn, inside the trial [t, t + h], beyond a switch that both ends have not passed. A
/// parabola turns within h/4 times the sum of its end slopes.
bool Substepper::may_turn_past_switch(const FlowBalance& balance, double t, double h,
                                      const Start& start) const {
  const double rate = balance.pressure_rate(end_rate_, t + h);
  const double reach = 0.25 * h * (std::abs(start.rate) + std::abs(rate));
  const bool peak = start.rate > 0.0 && rate < 0.0, dip = start.rate < 0.0 && rate > 0.0;
  switch (balance.regime()) {
    case Regime::kClosed:
      return peak && balance.is_open() && balance.pressure_excess() + reach > 0.0;
    case Regime::kChoked:
      return dip && balance.sonic_excess() - reach < 0.0;
    case Regime::kSubsonic:
      return peak && balance.sonic_excess() + reach > 0.0;
  }
  return false;
}

/// Shortens the trial to where p turns; 20 bits in time are 40 in p.
double Substepper::end_at_turn(FlowBalance& balance, const Vector& y, double t, double h,
                               const Start& start) {
  const auto rate = [&](double length) { return balance.pressure_rate(end_rate_, t + length); };
  return end_at(balance, y, t, h, start.rate, rate(h), 20, rate);
}

/// If the accepted trial [t, t + h] leaves its regime, shortens it to end at the switch and sets
/// next_regime_. Returns its length; zero if it has to be repeated in the next regime.
double Substepper::end_at_switch(FlowBalance& balance, const Vector& y, double t, double h,
                                 const Start& start) {
  next_regime_ = balance.regime();
  Switch passed = passed_switch(balance, t + h);
  if (passed == Switch::kNone && may_turn_past_switch(balance, t, h, start)) {
    h = end_at_turn(balance, y, t, h, start);
    passed = passed_switch(balance, t + h);
  }
  if (passed == Switch::kNone) return h;
  const bool sonic = passed == Switch::kSonic;
  if (balance.regime() != Regime::kSubsonic) {
    next_regime_ = Regime::kSubsonic;
  } else {
    next_regime_ = sonic ? Regime::kChoked : Regime::kClosed;
  }
  const double tolerance = kSwitchTolerance * balance.ambient_pressure();
  const double begin = sonic ? start.sonic : start.excess;
  const auto value = [&](double) {
    const double distance = sonic ? balance.sonic_excess() : balance.pressure_excess();
    return std::abs(distance) <= 0.5 * tolerance ? 0.0 : distance;
  };
  const double end = value(h);
  if (std::abs(begin) > tolerance && begin * end < 0.0)
    return end_at(balance, y, t, h, begin, end, 50, value);
  return balance.regime() == Regime::kClosed ? 0.0 : h;
}

void Substepper::switch_regime(FlowBalance& balance, const Vector& y, double t) {
  if (next_regime_ == balance.regime()) return;
  balance.set_regime(next_regime_);
  evaluate(balance, y, begin_rate_, t);
}

void Substepper::integrate(FlowBalance& balance, Vector& y, double a, double b) {
  start_regime(balance, y, a, b);
  double t = a, h = b - a;
  Start start = start_values(balance, t);
  while (t < b) {
    const bool last = h >= b - t;
    if (last) h = b - t;
    try_step(balance, y, t, h);
    const double error = scaled_error(balance);
    const double length = error <= 1.0 ? end_at_switch(balance, y, t, h, start) : 0.0;
    if (length > 0.0) {
      t = last && length == h ? b : t + length;
      y.swap(end_);
      begin_rate_.swap(end_rate_);
      ++accepted_;
    }
    if (error <= 1.0) switch_regime(balance, y, t);
    if (length > 0.0) start = start_values(balance, t);
    if (length > 0.0 || error > 1.0) h *= step_factor(error);
  }
}

}  // namespace gas
