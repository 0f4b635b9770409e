// SPDX-License-Identifier: Apache-2.0
// Where a balance lies within hold_near() of p_a, p is held there: what flows through the openings is what
// keeps it. The difference of the pressures, of which the flow is the root, would be rounding.
#include <algorithm>
#include <cmath>
#include <limits>

#include "flow_balance.hpp"
#include "near.hpp"
#include "substepper.hpp"

namespace gas {

/// Where the volume follows p, the gas changes by `compliance` times as much as p.
double FlowBalance::hold_near() const {
  return kHoldNear * ambient_pressure() / point_.compliance;
}

/// Fills the flows at `share` times hold_near() from p_a, out or in; returns what they do to V dp/dt [W].
double FlowBalance::flows_near_ambient(Vector& dydt, double t, bool out, double share) {
  point_.vent = point_.fabric = point_.back = 0.0;
  for (std::size_t i = 0; i < dydt.size(); ++i)
    if (is_flow(i)) dydt[i] = 0.0;
  if (out)
    outflow_rates(dydt, t, share * hold_near());
  else
    backflow_rates(dydt, t, -share * hold_near());
  // Exactly, where the openings are shut, or let through less than a rounding of what feeds them: outflow
  // lowers p, and the zero has its sign.
  const bool shut = point_.vent + point_.fabric + point_.back == 0.0;
  const double change = shut ? 0.0 : pressure_rate(t) * point_.volume - closed_pressure_growth(t);
  return out && !(change < 0.0) ? -0.0 : change;
}

double FlowBalance::relief(double t, double overpressure) {
  const double share = overpressure / hold_near();
  return -flows_near_ambient(scratch_, t, share > 0.0, std::abs(share)) / closed_pressure_growth(t);
}

bool FlowBalance::can_hold_back(double t) {
  return has_backflow() && flows_near_ambient(scratch_, t, false, 1.0) >= 0.0;
}

/// The flows that hold p, (G.22). Their share is infinite where the openings are shut that way. Of outflow,
/// negative, it is the smooth continuation for the stages of a sub-step that has to end where it is zero.
void FlowBalance::hold(Vector& dydt, double t) {
  const double growth = closed_pressure_growth(t);
  const double full = flows_near_ambient(dydt, t, regime_ == Regime::kHeldOut, 1.0);
  point_.share = growth == 0.0 ? 0.0 : -growth / full;
  double factor = std::isfinite(point_.share) ? point_.share : 0.0;
  if (regime_ == Regime::kHeldBack) factor = std::max(0.0, factor);  // ambient gas may not be there to leave
  for (std::size_t i = 0; i < dydt.size(); ++i)
    if (is_flow(i)) dydt[i] *= factor;
  point_.vent *= factor;
  point_.fabric *= factor;
  point_.back *= factor;
}

/// The overpressure at which the openings carry the share: flow ~ overpressure^n.
double FlowBalance::held_overpressure(double t) {
  const double share = point_.share;
  const bool out = regime_ == Regime::kHeldOut;
  if (!(share > 0.0)) return 0.0;
  const double full = flows_near_ambient(scratch_, t, out, 1.0);
  const double n = std::log(full / flows_near_ambient(scratch_, t, out, 0.25)) / std::log(4.0);
  return (out ? 1.0 : -1.0) * hold_near() * std::pow(std::min(1.0, share), 1.0 / n);
}

/// The overpressure at which outflow or backflow, not held, balances; by a power law near it, thrice.
double FlowBalance::balanced_overpressure(double t) {
  if (is_held()) return held_overpressure(t);
  const double sign = regime_ == Regime::kOut ? 1.0 : -1.0;
  double size = std::max(std::abs(pressure_excess()), hold_near());
  for (int i = 0; i < 3; ++i) {
    const double share = relief(t, sign * size);
    const double n = std::log(share / relief(t, sign * 0.25 * size)) / std::log(4.0);
    size *= std::pow(share, -1.0 / n);
  }
  return sign * size;
}

bool FlowBalance::is_on_balance(double t, double h, double error) {
  constexpr double kTimes = 30.0, kRounding = 64.0 * std::numeric_limits<double>::epsilon();
  const double growth = closed_pressure_growth(t), rate = std::abs(growth) / point_.volume;
  const double near = std::max(kTimes * error, 0.5 / kTimes * rate * kRounding * std::abs(t));
  if (!(regime_ == Regime::kOut ? growth > 0.0 : regime_ == Regime::kBack && growth < 0.0)) return false;
  if (std::abs(pressure_excess()) > near) return false;
  const Point kept = point_;
  const double balance = balanced_overpressure(t);
  point_ = kept;
  return std::abs(balance) <= near && std::abs(pressure_excess() - balance) <= 0.5 * rate * h &&
         2.0 * kTimes * std::abs(balance) <= rate * h;
}

void FlowBalance::settle(Vector& y, Vector& dydt, double t, double h) {
  // Newton's method: from an error of p of 1e-2, the largest tolerance, to rounding.
  for (int i = 0; i < 3; ++i) {
    const double balance = balanced_overpressure(t), excess = (pressure_excess() - balance) * point_.volume;
    double longer = excess / closed_pressure_growth(t);
    const Vector* rates = &dydt;
    if (!is_held()) {
      relief(t, balance);
      rates = &scratch_;
    }
    if (!(std::abs(longer) <= 0.5 * h)) {  // an error of p more than its flow in h
      if (excess < 0.0 && !has_backflow()) break;
      longer = -excess / flows_near_ambient(scratch_, t, excess > 0.0, 1.0);
      rates = &scratch_;
    }
    if (!std::isfinite(longer)) break;  // at rest
    const auto go_on = [&](double time) {
      for (std::size_t j = 0; j < y.size(); ++j)
        if (is_flow(j)) y[j] += time * (*rates)[j];
      locate(y, t);
    };
    go_on(longer);
    if (lacks_species()) {  // of ambient gas, that would have to leave again
      go_on(-longer);
      break;
    }
    fill_rates(dydt, t);
  }
  fill_rates(dydt, t);
}

/// Puts p of an implicit trial that ends at t on the balance to which it comes within far less than h, where
/// the tolerance does not tell it from there: the next trial would start beside it, with a matrix of another
/// slope. True if so.
bool Substepper::settle_trial(FlowBalance& balance, double t, double h) {
  if (std::isfinite(stepper_->stability_limit()) || options_.fixed_step > 0.0) return false;
  const auto& point = balance.point();
  const double error = options_.relative_tolerance * point.pressure / point.compliance;
  if (!balance.is_on_balance(t, h, error)) return false;
  balance.settle(trial_.end, trial_.end_rate, t, h);
  return true;
}

/// The same at t, the begin of sub-steps, where p has been left or has come to p_a.
bool Substepper::settle_start(FlowBalance& balance, double t, double b) {
  std::ranges::fill(trial_.end, 0.0);
  if (!settle_trial(balance, t, std::min(first_step(balance, t), b - t))) return false;
  balance.accept(trial_.end, t);
  start_hold(balance, t, b, 0.25);
  return true;
}

/// Sets the regime that holds p, if p is on its balance to `share` times hold_near() and can be held there
/// from t to b.
bool Substepper::start_hold(FlowBalance& balance, double t, double b, double share) {
  const double begin = balance.closed_pressure_growth(t);
  if (balance.ambient_pressure() == 0.0 || std::abs(balance.pressure_excess()) > share * balance.hold_near())
    return false;
  const double growth = begin != 0.0 ? begin : balance.closed_pressure_growth(b);
  if (!(growth > 0.0 ? balance.is_open() : growth < 0.0 && balance.has_backflow())) return false;
  const Regime before = balance.regime();
  balance.set_regime(growth > 0.0 ? Regime::kHeldOut : Regime::kHeldBack);
  balance.fill_rates(hold_rate_, t);
  if (balance.point().share >= 0.0 && balance.point().share <= share) return true;
  balance.set_regime(before);
  balance.fill_rates(hold_rate_, t);
  return false;
}

/// Whether the flow that holds p, from none, goes the other way at the end of a trial of length h, as it did
/// from there the way before, by more than the tolerance sees: between, it turns.
bool Substepper::hold_turns_back(const FlowBalance& balance, double h, const Start& start) const {
  const auto& point = balance.point();
  return options_.fixed_step == 0.0 && balance.is_held() && event_ == Event::kHold &&
         std::abs(start.share) < kShareNear && point.share < -kShareNear &&
         -h * (point.vent + point.fabric + point.back) > 0.1 * options_.relative_tolerance * point.mass;
}

Regime Substepper::regime_after_hold(FlowBalance& balance, double t, bool released) const {
  const bool out = balance.regime() == Regime::kHeldOut;
  if (released) return out ? Regime::kOut : Regime::kBack;
  if (out) return balance.can_hold_back(t) ? Regime::kHeldBack : Regime::kClosed;
  return Regime::kHeldOut;
}

}  // namespace gas
