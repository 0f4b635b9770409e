// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <optional>

#include "step_control.hpp"
#include "stepper.hpp"
#include "trigger_network.hpp"
#include "watch.hpp"

namespace gas {

/// Takes the sub-steps of one segment: proposes a length, tries it by the method that suits, repeats it if its
/// error is too large, lands it on what Watch finds, and books it.
class Substepper {
 public:
  /// All must outlive this.
  Substepper(const Boundary& boundary, Ledger& ledger, const TriggerNetwork& network,
             const IntegratorOptions& options);

  /// Resets the counters. Throws DomainError if the temperature of `state` is out of range.
  void begin_step(const ControlVolumeState& state);
  /// Advances from a towards b; returns the time reached: b, or earlier if a pressure sensor switches there.
  /// Throws DomainError.
  double integrate(double a, double b, const TriggerState& triggers);

  Balance& balance() { return system_.balance; }
  int accepted() const { return accepted_; }
  int evaluations() const { return system_.evaluations; }
  const StepMoments& moments() const { return moments_; }

 private:
  void start(double t, double b);
  void start_clock(double t, double b);
  bool is_onset() const;
  bool is_stiff(double length) const;
  bool try_step(double length, bool stiff);
  double fill_first(double t, double b);
  void note_moments(const Moment& end, double t, double duration, bool landed);
  void accept(double end, double t, double b, bool landed, double after);
  void set_relaxation(double length);

  const IntegratorOptions options_;
  const TriggerNetwork& network_;
  Balance balance_;
  System system_;
  const Watch watch_;
  const StepControl control_;
  std::unique_ptr<Stepper> explicit_, implicit_;
  Trial trial_;
  Vector begin_rate_;
  Moment begin_{};
  double x_ = 0.0;           // where the sub-step begins
  double relaxation_ = 0.0;  // [1/s] there
  int attempts_ = 0, accepted_ = 0;
  StepMoments moments_;
};

}  // namespace gas
