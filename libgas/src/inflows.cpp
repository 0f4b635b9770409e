// SPDX-License-Identifier: Apache-2.0
#include "inflows.hpp"

#include <algorithm>

#include "limits.hpp"

namespace gas {

Inflows::Inflows(const ControlVolumeModel& model) : model_(model), segments_(model.inflows.size()) {
  for (const Inflow& inflow : model.inflows) mixtures_.push_back(model.thermo.mixture(inflow.mass_fractions));
}

double Inflows::next_break(const TriggerState& triggers, double t) const {
  double next = kInfinity;
  for (std::size_t i = 0; i < segments_.size(); ++i)
    next = std::min(next, gas::next_break(model_.inflows[i], firing_time(model_.inflows[i], triggers),
                                          mixtures_[i].constant_cp, t));
  return next;
}

void Inflows::begin_segment(const TriggerState& triggers, double a, double b) {
  for (std::size_t i = 0; i < segments_.size(); ++i)
    segments_[i] =
        InflowSegment(model_.inflows[i], firing_time(model_.inflows[i], triggers), mixtures_[i], a, b);
}

double Inflows::mass(double t0, double t1) const {
  double sum = 0.0;
  for (const InflowSegment& segment : segments_) sum += segment.delivered(t0, t1).mass;
  return sum;
}

}  // namespace gas
