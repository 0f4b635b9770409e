// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "inflow_segment.hpp"

namespace gas {

/// All inflows of a volume, over a segment of time in which none fires, ends or passes a knot. An amount of
/// gas is (m_k [kg] of each species, U [J]).
class Inflows {
 public:
  /// `model` must outlive this object.
  explicit Inflows(const ControlVolumeModel& model);

  /// First time after t at which an inflow is not smooth.
  double next_break(const TriggerState& triggers, double t) const;
  void begin_segment(const TriggerState& triggers, double a, double b);
  void end_segment();

  std::size_t size() const { return segments_.size(); }
  const InflowSegment& operator[](std::size_t i) const { return segments_[i]; }
  /// Adds mass and enthalpy of `stream` from inflow i to `gas`.
  void add(std::size_t i, const InflowSegment::Delivered& stream, std::span<double> gas) const;
  /// Adds what all inflows deliver from t0 to t1 [s].
  void add_delivered(double t0, double t1, std::span<double> gas) const;
  /// Adds factor times their rates at t, or the rates' derivatives by t.
  void add_rates(double factor, double t, std::span<double> gas) const;
  void add_slopes(double factor, double t, std::span<double> gas) const;
  /// Mass [kg] of all from t0 to t1 [s].
  double mass(double t0, double t1) const;

 private:
  const ControlVolumeModel& model_;
  std::vector<Mixture> mixtures_;  // 1 kg of each inflow
  std::vector<InflowSegment> segments_;
};

}  // namespace gas
