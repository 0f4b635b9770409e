// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gas/error.hpp"
#include "stepper.hpp"
#include "trigger_network.hpp"

namespace gas {

/// Sub-steps that became too many or too short.
struct TooStiff : DomainError {
  using DomainError::DomainError;
};

/// Integrates a FlowBalance over one segment with one of the methods; sub-steps end where the flow changes
/// regime, where p passes a knot of the curves of openings and volume, and where it reaches the threshold of
/// a pressure sensor.
class Substepper {
 public:
  using Vector = FlowBalance::Vector;

  /// `levels` [Pa]: overpressures where sub-steps end, those of the curves' knots and of the pressure
  /// sensors.
  Substepper(const FlowBalance& balance, std::vector<double> levels, const IntegratorOptions& options);

  /// Resets the counters.
  void begin_step();
  /// Advances `balance` from a towards b, in a segment begun there; returns the time reached: b, or earlier
  /// if p came to a level (knots and triggers are to be brought up to date). Throws DomainError.
  double integrate(FlowBalance& balance, double a, double b);

  /// The level [Pa] on which the last sub-step ended, once: p itself is as close to it as the
  /// method's rounding.
  std::optional<double> take_level() { return std::exchange(level_, std::nullopt); }
  int accepted() const { return accepted_; }
  int evaluations() const { return evaluations_; }

 private:
  /// Distances [Pa] to the switches; the first is the overpressure.
  struct Place {
    double excess, sonic, back_sonic;
  };
  /// The same at the begin of a sub-step, with the rate of the pressure [Pa/s].
  struct Start {
    Place place;
    double rate, share;  // FlowBalance::Point::share
  };
  enum class Event { kNone, kAmbient, kSonic, kBackSonic, kLevelAbove, kLevelBelow, kHold };

  // substepper.cpp: steps
  bool try_step(Rates& rates, double x, double h);
  double scaled_error(const FlowBalance& balance) const;
  void count_attempt(const Rates& rates, double x, double h);
  void start_regime(FlowBalance& balance, double t, double b);
  void enter_band(FlowBalance& balance) const;
  double ambient_near(const FlowBalance& balance) const;
  double level_near(const FlowBalance& balance, std::size_t i) const;
  std::size_t band_above(const FlowBalance& balance) const;
  std::size_t band_below(const FlowBalance& balance) const;
  void find_band(FlowBalance& balance, double t);
  bool pass_event(FlowBalance& balance);

  // step_length.cpp
  double step_factor(double error) const;
  double first_step(const FlowBalance& balance, double t) const;
  bool is_onset(const FlowBalance& balance, double t) const;
  bool is_steady(const FlowBalance& balance, double t, double b) const;
  void start_variable(Rates& rates, double t, double b);
  void start_fixed_steps(Rates& rates, double t, double b, bool onset);
  bool may_leave_root(const Rates& rates, double t) const;
  double rounding_limit(const FlowBalance& balance) const;
  double longest_step(const Rates& rates, double t) const;

  // substepper_errors.cpp: why a step cannot be, or has to be repeated
  void require_volume(const FlowBalance& balance, double t) const;
  void require_stable(const Rates& rates, double x, double h) const;
  [[noreturn]] void fail(const Rates& rates, double x, double h) const;
  std::string advice(const FlowBalance& balance, double length) const;
  [[noreturn]] void fail_crossing(double t) const;
  [[noreturn]] void fail_standing(double t) const;
  bool stands_still(const Rates& rates, double x, double h, const Start& start) const;
  bool lags_behind_balance(const FlowBalance& balance, double begin, double end, const Start& start) const;
  bool ends_as_root() const;
  bool flows_backwards(const FlowBalance& balance) const;

  // first_gas.cpp, held_pressure.cpp
  double fill_first(Rates& rates, double a, double b);
  bool settle_trial(FlowBalance& balance, double t, double h);
  bool settle_start(FlowBalance& balance, double t, double b);
  bool start_hold(FlowBalance& balance, double t, double b, double share);
  bool hold_turns_back(const FlowBalance& balance, double h, const Start& start) const;
  Regime regime_after_hold(FlowBalance& balance, double t, bool released) const;

  // events.cpp: where a sub-step has to end
  Start start_values(const FlowBalance& balance, double t) const;
  Event passed_switch(const FlowBalance& balance, double t) const;
  Event passed_level(const FlowBalance& balance) const;
  bool crosses_against_flow(const FlowBalance& balance, double t, const Start& start) const;
  bool may_turn_past_event(const FlowBalance& balance, double t, double h, const Start& start) const;
  Place place(const FlowBalance& balance) const;
  double distance(const Place& at, Event event) const;
  double closeness(const FlowBalance& balance, Event event) const;
  Regime regime_after(const FlowBalance& balance, Event event, double t) const;
  double end_at_turn(Rates& rates, double x, double h, const Start& start);
  double end_at(Event event, Rates& rates, double x, double h, const Start& start);
  double end_of_hold(Rates& rates, double x, double h, double start_share, bool turned);
  double end_at_switches(Rates& rates, double x, double h, const Start& start);
  double end_at_events(Rates& rates, double x, double h, const Start& start);
  template <class Function>
  double end_at_zero(Rates& rates, double x, double h, double begin, double end, int bits, Function function);

  IntegratorOptions options_;
  std::vector<double> levels_;  // [Pa] overpressures, rising
  double sonic_near_;           // [Pa] pressures closer to a sonic switch than this are on it
  std::unique_ptr<Stepper> stepper_;
  double first_step_share_;  // [-] relative change of the gas in a first step
  Stepper::Trial trial_;
  const Vector zero_;  // the unknowns at the begin of each sub-step
  Vector begin_rate_, hold_rate_;
  std::size_t band_ = 0;        // p - p_a lies between levels_[band_ - 1] and levels_[band_]
  bool band_is_known_ = false;  // since the last sub-step ended on a level
  std::optional<double> level_;
  Event event_ = Event::kNone;
  Regime next_regime_ = Regime::kClosed;
  double onset_begin_ = 0.0, onset_step_ = 0.0;  // [s] of flow from p_a; the first fixed sub-step of it
  int attempts_ = 0, accepted_ = 0, evaluations_ = 0;
};

}  // namespace gas
