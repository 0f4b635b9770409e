// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include "flow_balance.hpp"

namespace gas {

/// Integrates a FlowBalance over one segment: Dormand-Prince 5(4) with error control, sub-steps ending where
/// the outflow changes regime.
class Substepper {
 public:
  using Vector = FlowBalance::Vector;

  Substepper(std::size_t unknowns, const IntegratorOptions& options);

  /// Resets the counters.
  void begin_step();
  /// Advances y from a to b, a segment begun in `balance`. Throws DomainError.
  void integrate(FlowBalance& balance, Vector& y, double a, double b);

  int accepted() const { return accepted_; }
  int evaluations() const { return evaluations_; }

 private:
  /// FlowBalance::pressure_excess, sonic_excess [Pa] and pressure_rate [Pa/s] at the begin of a sub-step.
  struct Start {
    double excess;
    double sonic;
    double rate;
  };
  enum class Switch { kNone, kAmbient, kSonic };

  void evaluate(FlowBalance& balance, const Vector& y, Vector& dydt, double t);
  void try_step(FlowBalance& balance, const Vector& y, double t, double h);
  double scaled_error(const FlowBalance& balance) const;
  void start_regime(FlowBalance& balance, const Vector& y, double t, double b);
  Start start_values(const FlowBalance& balance, double t) const;
  Switch passed_switch(const FlowBalance& balance, double t) const;
  bool may_turn_past_switch(const FlowBalance& balance, double t, double h, const Start& start) const;
  double end_at_turn(FlowBalance& balance, const Vector& y, double t, double h, const Start& start);
  double end_at_switch(FlowBalance& balance, const Vector& y, double t, double h, const Start& start);
  template <class Event>
  double end_at(FlowBalance& balance, const Vector& y, double t, double h, double begin_value,
                double end_value, int bits, Event event);
  void switch_regime(FlowBalance& balance, const Vector& y, double t);
  void count_attempt(const FlowBalance& balance, double t, double h);

  IntegratorOptions options_;
  boost::numeric::odeint::runge_kutta_dopri5<Vector> stepper_;
  Vector begin_rate_, end_, end_rate_, error_;
  Regime next_regime_ = Regime::kClosed;
  int attempts_ = 0, accepted_ = 0, evaluations_ = 0;
};

}  // namespace gas
