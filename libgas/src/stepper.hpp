// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <memory>

#include "balance.hpp"
#include "ledger.hpp"

namespace gas {

/// Variable x of the sub-steps: the time t since the begin of the segment, or sqrt(t - origin). Flow that
/// sets in at p = p_a, at the time `origin`, is smooth only as a function of that root.
struct Clock {
  bool root = false;
  double origin = 0.0;  // [s]
  double time(double x) const { return root ? origin + x * x : x; }
  double position(double t) const { return root ? std::sqrt(std::max(0.0, t - origin)) : t; }
  double slope(double x) const { return root ? 2.0 * x : 1.0; }  // dt/dx
  double slope_of_slope() const { return root ? 2.0 : 0.0; }     // d2t/dx2
};

/// Counters: sub-steps tried and accepted, evaluations of the right-hand side.
struct Effort {
  int attempts = 0, accepted = 0, evaluations = 0;
};

/// The right-hand side dy/dx for a stepper.
struct System {
  Ledger& ledger;
  Balance balance;
  Clock clock{};
  Vector gas;         // scratch: an amount (m_k, U)
  bool valid = true;  // all evaluations of the trial had a valid gas
  Effort effort{};

  /// dy/dx at (y, x).
  void rates(const Vector& y, Vector& dydx, double x);
  /// dy/dx at an amount of gas.
  void rates_of(const Vector& amount, Vector& dydx, double x);
};

/// Result of a step.
struct Trial {
  Vector end, end_rate, error;
  double reversed = 0.0;  // [kg] removed because it flowed the wrong way by an error of the method
};

/// An integration method.
class Stepper {
 public:
  virtual ~Stepper() = default;
  /// Steps from y = 0, with the rates dydx at x, to x + h. The balance is then located at the end. Fills
  /// `error` if `estimate`.
  virtual void step(System& system, const Vector& dydx, double x, double h, bool estimate, Trial& out) = 0;
  /// The error of a step grows as h to this power.
  virtual double error_power() const = 0;
};

std::unique_ptr<Stepper> make_explicit(Method method, const Slots& slots);
std::unique_ptr<Stepper> make_rodas(const Slots& slots);

}  // namespace gas
