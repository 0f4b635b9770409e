// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <vector>

#include "balance.hpp"

namespace gas {

/// What decides, at one end of a trial, whether it has to end elsewhere.
struct Moment {
  double overpressure;       // [Pa]
  double rate;               // [Pa] per unit of the clock's x
  double compliance;         // [-]
  double sonic, sonic_rate;  // [Pa] > 0 where vents are choked; [Pa] per unit of x
  double growth;             // [Pa/s] dp/dt with the openings shut
  double outflow, backflow;  // [kg/s]
};

/// Finds where p passes what a sub-step must end on, as the rates are not smooth there: p_a, from where flow
/// sets in or turns; the sonic switch; knots of the curves against overpressure; thresholds of the sensors.
class Watch {
 public:
  /// `boundary` must outlive this.
  Watch(const Boundary& boundary, double tolerance);

  /// The gas that `balance` has located; `slope` is dt/dx of the clock.
  Moment moment(const Balance& balance, double slope) const;
  /// Share of the trial of length h after which it first passes one of them, by the cubic through both ends;
  /// also where it may turn beyond one. Ends that are close to one have not passed it.
  std::optional<double> landing(const Moment& begin, const Moment& end, double h) const;
  bool is_on_ambient(const Moment& at) const;  // p is p_a, as close as it is landed on
  /// Whether flow that something feeds lets p grow at more than half of the rate that it would have without.
  bool is_onset(const Balance& balance, const Moment& at) const;
  /// Share of a trial of length h after which the flow of the vents switched, if it did.
  std::optional<double> switches(const Moment& begin, const Moment& end, double h) const;
  /// Share of it after which flow, rather than what else moves p, brought p to p_a, to 1e-7 of it.
  std::optional<double> equalises(const Moment& begin, const Moment& end) const;
  /// How long flow that only runs out or in leads p to p_a, as the square of the time that is left; in x.
  /// Infinite where p goes elsewhere, or is as close as laminar flow.
  double until_ambient(const Moment& begin) const;
  /// Whether the trial takes p through p_a against what feeds the flow, by an error of the method.
  bool crosses_against_flow(const Moment& begin, const Moment& end, double duration) const;

 private:
  struct Level {
    double overpressure;  // [Pa]
    double near;          // [Pa] p closer to it than this is on it
  };
  /// One watched value at both ends of a trial, with slopes for the whole of it.
  struct Course {
    double begin, begin_slope, end, end_slope;
    double at(double share) const;
    std::optional<double> turn() const;
    std::optional<double> passing(double near) const;
  };

  const Boundary& boundary_;
  double ambient_near_, sonic_near_;  // [Pa]
  std::vector<Level> levels_;
};

}  // namespace gas
