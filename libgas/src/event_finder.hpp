// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <vector>

#include "balance.hpp"

namespace gas {

/// State at one end of a trial. From both ends EventFinder decides whether the trial must end earlier.
struct Moment {
  double overpressure;  // [Pa]
  double rate;          // [Pa] per unit of x
  double compliance;    // [-]
  /// [Pa] > 0 where vents are choked; [Pa] per unit of x.
  double sonic, sonic_rate;
  double growth;  // [Pa/s] dp/dt with the openings shut
  double flow;    // [kg/s] out through the openings; below zero: in
};

/// Finds where p passes a level on which a sub-step must end, because the rates are not smooth there. Levels:
/// p_a, where flow sets in or turns; the sonic switch; knots of curves over the overpressure; thresholds of
/// sensors.
class EventFinder {
 public:
  /// `boundary` must outlive this object.
  EventFinder(const Boundary& boundary, double tolerance);

  /// State of the gas that `balance` has located; `slope` is dt/dx of the clock.
  Moment moment(const Balance& balance, double slope) const;
  /// Share of a trial of length h after which it first passes a level, by the cubic through both ends. The
  /// cubic also shows an excursion beyond a level and back. An end that is close to a level has not passed
  /// it. `again`: this trial was meant to end on a level, and passed it.
  std::optional<double> landing(const Moment& begin, const Moment& end, double h, bool again) const;
  bool is_on_ambient(const Moment& at) const;  // True if p equals p_a within the accuracy of landing().
  /// True if gas flows out (`side` > 0) or in, or is about to, from p_a.
  bool is_led(const Moment& at, double side) const;
  /// True if fed flow sets in: dp/dt is at least half of its value with the openings shut.
  bool is_onset(const Balance& balance, const Moment& at) const;
  /// Share of a trial of length h after which the vents became choked or unchoked; empty if they did not.
  std::optional<double> switches(const Moment& begin, const Moment& end, double h) const;
  /// Share of a trial after which flow through the openings brought p within 1e-7 of p_a.
  std::optional<double> equalises(const Moment& begin, const Moment& end) const;
  /// Time, in x, after which flow that is not fed brings p to p_a, if p - p_a falls as the square of the time
  /// left. Infinite if p does not tend to p_a, or is already in the laminar range.
  double until_ambient(const Moment& begin) const;
  /// Share of that time which is left after a trial; 1 if flow does not lead p to p_a. Sub-steps shrink with
  /// it, because the flow changes over that time.
  double time_kept(const Moment& begin, const Moment& end) const;
  /// True if the trial takes p through p_a against the feed of the flow, which is an error of the method.
  bool crosses_against_flow(const Moment& begin, const Moment& end, double duration) const;

 private:
  struct Level {
    double overpressure;  // [Pa]
    double near;          // [Pa] p this close to the level is on it
  };
  /// A watched value at both ends of a trial, with its slopes per trial.
  struct Course {
    double begin, begin_slope, end, end_slope;
    double at(double share) const;
    std::optional<double> turn() const;
    std::optional<double> passing(double begin_near, double end_near, bool again) const;
  };

  const Boundary& boundary_;
  double ambient_near_, sonic_near_;  // [Pa]
  std::vector<Level> levels_;
};

}  // namespace gas
