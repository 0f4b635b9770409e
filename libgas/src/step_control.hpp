// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "gas/error.hpp"
#include "stepper.hpp"
#include "watch.hpp"

namespace gas {

/// Sub-steps that became too many or too short.
struct TooStiff : DomainError {
  using DomainError::DomainError;
};

/// How long a sub-step may be, and why one cannot be taken. All lengths are in t [s].
class StepControl {
 public:
  /// `error_power` is that of the method in use where the gas is not stiff.
  StepControl(const IntegratorOptions& options, double error_power);

  bool is_fixed() const { return options_.fixed_step > 0.0; }
  /// Error of mass and of thermal energy (what an error of a mass takes along at its own h is no error of
  /// temperature) at the gas located, over the tolerance; 0 for fixed sub-steps.
  double scaled_error(const System& system, const Vector& error, Vector& scratch) const;
  /// What a length is multiplied by after an error.
  double factor(double error, double error_power) const;
  /// A first length from how fast the gas changes; infinite for none.
  double first_step(const Balance& balance) const;
  /// The longest; `relaxation` [1/s] is that of flow and walls together. For an explicit method alone, its
  /// limit.
  double longest(const Balance& balance, double relaxation) const;
  /// Above the rate [1/s] at which the gas relaxes, without the cost of it; infinite where that is not known.
  double relaxation_bound(const Balance& balance) const;
  /// Whether the tolerance tells p_a + overpressure from p_a.
  bool tells(const Balance& balance, double overpressure) const;
  /// Throws DomainError where a fixed length is past the limit of its method: where inflow feeds what leaves,
  /// or walls or expansion draw in what comes back, an error grows. Where gas only runs out or in, p = p_a
  /// ends it.
  void require_stable(const Balance& balance, double length) const;

  /// Throws where p, after a fixed explicit sub-step, is about where it was though its rates at both ends
  /// would have moved it far: between it has turned, past the method's limit on a balance that it misses.
  void require_motion(const Balance& balance, const Moment& begin, const Moment& end, double length) const;

  /// Throws the DomainError that says why a sub-step of `length` cannot be taken from its start at time t.
  /// `found_gas`: the last trial had a temperature.
  [[noreturn]] void fail(System& system, double t, double length, bool found_gas) const;
  /// The same for a fixed one that takes p through p_a against what feeds the flow.
  [[noreturn]] void fail_crossing(double t) const;

 private:
  double rounding_limit(const Balance& balance) const;
  double limit() const;
  std::string advice(const Balance& balance, double length) const;

  const IntegratorOptions options_;
  double first_share_;  // [-] relative change of the gas in a first step
};

}  // namespace gas
