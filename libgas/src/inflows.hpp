// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "inflow_segment.hpp"

namespace gas {

/// All inflows of a volume, over a segment of time in which none fires, ends or passes a knot. Times of
/// amounts count from the begin of the segment. An amount of gas is (m_k [kg] of each species, U [J]).
class Inflows {
 public:
  /// `model` must outlive this object.
  explicit Inflows(const ControlVolumeModel& model);

  /// First time after t at which an inflow is not smooth.
  double next_break(const TriggerState& triggers, double t) const;
  void begin_segment(const TriggerState& triggers, double a, double b);

  std::size_t size() const { return segments_.size(); }
  const InflowSegment& operator[](std::size_t i) const { return segments_[i]; }
  /// Adds factor times amount(segment) of each flowing inflow to `gas`. The amount may be a delivery, a rate
  /// or the rate's derivative.
  template <class Amount>
  void add(double factor, Amount amount, std::span<double> gas) const {
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      if (segments_[i].is_idle()) continue;
      const auto [mass, enthalpy] = amount(segments_[i]);
      const auto& fractions = model_.inflows[i].mass_fractions;
      for (std::size_t k = 0; k < fractions.size(); ++k) gas[k] += fractions[k] * (factor * mass);
      gas[fractions.size()] += factor * enthalpy;
    }
  }
  /// Mass [kg] delivered by all inflows from t0 to t1 [s].
  double mass(double t0, double t1) const;

 private:
  const ControlVolumeModel& model_;
  std::vector<Mixture> mixtures_;  // 1 kg of each inflow
  std::vector<InflowSegment> segments_;
};

}  // namespace gas
