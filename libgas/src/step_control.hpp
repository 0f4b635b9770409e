// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "event_finder.hpp"
#include "gas/error.hpp"
#include "stepper.hpp"

namespace gas {

/// Thrown when sub-steps become too many or too short.
struct TooStiff : DomainError {
  using DomainError::DomainError;
};

/// Length of a sub-step, and the error if none can be taken. All lengths are in t [s].
class StepControl {
 public:
  explicit StepControl(const IntegratorOptions& options);

  bool is_fixed() const { return options_.fixed_step > 0.0; }
  /// Error of mass and of thermal energy at the located gas, divided by the tolerance; 0 for fixed sub-steps.
  /// The enthalpy of an error of mass does not count as an error of temperature.
  double scaled_error(const System& system, const Vector& error, Vector& scratch) const;
  /// Factor for the next length after an error.
  double factor(double error, double error_power) const;
  /// First length, from the rate at which the gas changes; infinite if it does not change.
  double first_step(const Balance& balance) const;
  /// Longest length; `relaxation` [1/s] is the rate of flow and walls. For explicit methods it is their
  /// stability limit.
  double longest(const Balance& balance, double relaxation) const;
  /// True if the tolerance distinguishes p_a + overpressure from p_a.
  bool tells(const Balance& balance, double overpressure) const;
  /// True if flow that is not fed is about to end: the tolerance does not distinguish p from p_a.
  bool is_ending(const Balance& balance, const Moment& at) const;
  /// Throws DomainError if a fixed length is above the stability limit of its method: by the rate of flow and
  /// walls where the flow is fed (inflow feeds outflow; walls or expansion draw in backflow), otherwise by
  /// the rate of the walls. Flow that is not fed ends at p = p_a.
  void require_stable(const Balance& balance, double length, double relaxation) const;

  /// Throws DomainError if p hardly moves in a fixed explicit sub-step though its rates at both ends are
  /// large. Then p passed an equilibrium in between, where the sub-step is above the stability limit.
  void require_motion(const Balance& balance, const Moment& begin, const Moment& end, double length) const;

  /// True if a sub-step of `length` from time t [s] of the segment is shorter than rounding resolves, or than
  /// the first gas of an empty volume needs.
  bool is_too_short(const Balance& balance, double t, double length) const;
  /// Throws the DomainError that says why a sub-step of `length` cannot be taken from time t [s] of the
  /// segment.
  /// `found_gas`: the last trial found a temperature.
  [[noreturn]] void fail(System& system, double t, double length, bool found_gas) const;
  /// The same for a fixed sub-step that takes p through p_a against the feed of the flow.
  [[noreturn]] void fail_crossing(const Balance& balance) const;

 private:
  double rounding_limit(const Balance& balance) const;
  /// Stability limit of the method; infinite for the default method under error control, which can turn
  /// implicit.
  double limit() const;
  std::string advice(const Balance& balance, double length) const;

  const IntegratorOptions options_;
  double first_share_;  // [-] relative change of the gas in a first step
};

}  // namespace gas
