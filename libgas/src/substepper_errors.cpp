// SPDX-License-Identifier: Apache-2.0
// Substepper: why a sub-step cannot be taken.
#include <cmath>
#include <string>

#include "gas/error.hpp"
#include "pressure_volume.hpp"
#include "require.hpp"
#include "substepper.hpp"

namespace gas {

void Substepper::fail(const Rates& rates, double x, double h) const {
  FlowBalance& balance = rates.balance;
  const auto& point = balance.point();
  const Thermo& thermo = rates.balance.thermo();
  const bool fixed = options_.fixed_step > 0.0;
  const std::string where = "at t = " + to_text(rates.time(x)) + " s with a sub-step of " +
                            to_text(rates.time(x + h) - rates.time(x)) + " s";
  if (rates.depleted)
    throw DomainError("species " + thermo.species(*rates.depleted).name +
                      " runs out: more of it would leave than there is, " + where +
                      (fixed ? "; a shorter one (gas_step of a case), or none, is allowed" : ""));
  if (!point.valid)
    throw DomainError("the gas leaves its temperature range, " + to_text(thermo.minimum_temperature()) +
                      " to " + to_text(thermo.maximum_temperature()) + " K, " + where);
  Vector rate(zero_);
  balance.locate(zero_, rates.time(x));
  balance.fill_rates(rate, rates.time(x));
  const std::string gas =
      ", p = " + to_text(point.pressure) + " Pa and T = " + to_text(point.temperature) + " K";
  if (fixed)
    throw DomainError("a fixed sub-step of " + to_text(options_.fixed_step) + " s takes more than " +
                      std::to_string(options_.maximum_steps) + " sub-steps, " + where + gas +
                      "; a longer one (gas_step of a case), or none, is allowed");
  const double relaxation = balance.relaxation_rate() + balance.heat_rate();
  const bool is_explicit = std::isfinite(stepper_->stability_limit());
  throw TooStiff("the gas is too stiff for the integrator: " + std::to_string(attempts_) + " sub-steps, " +
                 where + gas +
                 (relaxation > 0.0 ? "; it relaxes within " + to_text(1.0 / relaxation) + " s" : "") +
                 (is_explicit ? "; Rosenbrock 4 (gas_method of a case) has no such limit" : ""));
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
  const double growth = balance.closed_pressure_growth(x);
  const bool fed = balance.point().back > 0.0 ? growth < 0.0 : growth > 0.0;
  const double rate = balance.heat_rate() + (fed ? balance.relaxation_rate() : 0.0);
  const double limit = stepper_->stability_limit();
  if (!(h * rate > limit)) return;
  throw DomainError("the step " + to_text(h) + " s is above the method's stability limit " +
                    to_text(limit / rate) + " s at t = " + to_text(x) + " s, where the gas relaxes within " +
                    to_text(1.0 / rate) + " s");
}

/// A fixed step that crosses so is above the limit of the balance that it has yet to reach.
void Substepper::fail_crossing(double x, double h) const {
  throw DomainError("the step " + to_text(h) +
                    " s is too long for the balance near ambient pressure at t = " + to_text(x) +
                    " s: flow through the openings takes p past p_a, where it would turn; "
                    "a shorter one (gas_step of a case), or none, is allowed");
}

}  // namespace gas
