// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <optional>

#include "event_finder.hpp"
#include "limits.hpp"
#include "step_control.hpp"
#include "stepper.hpp"
#include "trigger_network.hpp"

namespace gas {

/// Takes the sub-steps of one segment. It proposes a length and a method and tries them. It repeats the
/// sub-step if the error is too large, ends it where EventFinder finds an event, and adds it to the ledger.
class Substepper {
 public:
  /// All arguments must outlive this object.
  Substepper(const Boundary& boundary, Ledger& ledger, const TriggerNetwork& network,
             const IntegratorOptions& options);

  /// Resets the counters. `temperature` [K] is the first guess; an empty volume keeps it.
  void begin_step(double temperature);
  /// Advances over the segment of the boundary. Returns the time reached since its begin: its length, or
  /// less if a pressure sensor switches there. Throws DomainError.
  double integrate(const TriggerState& triggers);

  Balance& balance() { return system_.balance; }
  const Effort& effort() const { return system_.effort; }
  const StepMoments& moments() const { return moments_; }

 private:
  /// Start of a sub-step.
  struct Begin {
    double t, x;  // [s] since the begin of the segment; x of the clock
    Vector rate;  // dy/dx
    Moment moment;
    double relaxation;  // [1/s] of the gas
  };
  /// The next trial. Lengths are in x.
  struct Proposal {
    double length;
    double landing = kInfinity;  // if finite, the trial must end there, on an event that EventFinder found
    bool stiff = false;          // take the implicit method
  };
  /// Extent of a trial.
  struct Reach {
    double length;  // in x
    double end;     // [s] of the segment
  };

  void start(double t, double b);
  void start_clock(double b);
  void set_relaxation(double length);
  Reach reach(const Proposal& proposal, double b) const;
  void stop_at_ambient(double x);
  double try_step(const Reach& reach, bool stiff);
  std::optional<Proposal> again(const Proposal& tried, const Reach& reach, const Moment& end) const;
  void accept(const Reach& reach, const Moment& end, bool landed, double after, double b);

  const IntegratorOptions options_;
  const bool may_switch_;  // the method may switch to implicit and back
  const TriggerNetwork& network_;
  const EventFinder events_;
  const StepControl control_;
  const std::unique_ptr<Stepper> explicit_, implicit_;
  System system_;
  Begin begin_;
  Trial trial_;
  StepMoments moments_;
};

}  // namespace gas
