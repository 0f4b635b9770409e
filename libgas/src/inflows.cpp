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

void Inflows::end_segment() {
  std::ranges::fill(segments_, InflowSegment());
}

void Inflows::add(std::size_t i, const InflowSegment::Delivered& stream, std::span<double> gas) const {
  const auto& fractions = model_.inflows[i].mass_fractions;
  for (std::size_t k = 0; k < fractions.size(); ++k) gas[k] += fractions[k] * stream.mass;
  gas[fractions.size()] += stream.enthalpy;
}

void Inflows::add_delivered(double t0, double t1, std::span<double> gas) const {
  for (std::size_t i = 0; i < segments_.size(); ++i)
    if (!segments_[i].is_idle()) add(i, segments_[i].delivered(t0, t1), gas);
}

void Inflows::add_rates(double factor, double t, std::span<double> gas) const {
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    if (segments_[i].is_idle()) continue;
    const auto [mass, enthalpy] = segments_[i].rate(t);
    add(i, {factor * mass, factor * enthalpy}, gas);
  }
}

void Inflows::add_slopes(double factor, double t, std::span<double> gas) const {
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    if (segments_[i].is_idle()) continue;
    const auto [mass, enthalpy] = segments_[i].rate_slope(t);
    add(i, {factor * mass, factor * enthalpy}, gas);
  }
}

double Inflows::mass(double t0, double t1) const {
  double sum = 0.0;
  for (const InflowSegment& segment : segments_) sum += segment.delivered(t0, t1).mass;
  return sum;
}

}  // namespace gas
