// SPDX-License-Identifier: Apache-2.0
// FlowBalance: what the gas holds. It is carried from sub-step to sub-step, not as what it held at the step's
// begin less what has passed since: through a tiny volume that is so much more that the difference would be
// rounding.
#include <algorithm>
#include <numeric>

#include "flow_balance.hpp"

namespace gas {
namespace {

// A species that runs out leaves a remainder of round-off, of either sign, relative to what passed through.
constexpr double kMassRoundOff = 1e-13;

}  // namespace

void FlowBalance::begin_books(const ControlVolumeState& state) {
  for (std::size_t k = 0; k < masses_.size(); ++k) base_[k] = state.masses[k];
  base_.back() = state.internal_energy;
  std::ranges::fill(totals_, CompensatedSum{});
  std::ranges::fill(delivered_, StreamFlux{});
  std::ranges::fill(received_, Received{});
}

void FlowBalance::end_segment(double reached) {
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    if (reached != base_time_) {
      const auto [mass, enthalpy] = segments_[i].delivered(base_time_, reached);
      add_inflow(i, mass, enthalpy);
    }
    delivered_[i].mass += received_[i].mass.value();
    delivered_[i].enthalpy += received_[i].enthalpy.value();
    received_[i] = {};
    segments_[i] = InflowSegment();
  }
  if (volume_by_pressure_) volume_by_pressure_->leave_piece();
}

void FlowBalance::add_inflow(std::size_t i, double mass, double enthalpy) {
  for (std::size_t k = 0; k < masses_.size(); ++k) base_[k].add(model_.inflows[i].mass_fractions[k] * mass);
  base_.back().add(enthalpy);
  received_[i].mass.add(mass);
  received_[i].enthalpy.add(enthalpy);
}

void FlowBalance::keep_masses_non_negative() {
  for (std::size_t k = 0; k < masses_.size(); ++k)
    if (base_[k].value() < 0.0) base_[k] = 0.0;
}

void FlowBalance::accept(Vector& y, double t) {
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const auto [mass, enthalpy] = segments_[i].delivered(base_time_, t);
    add_inflow(i, mass, enthalpy);
  }
  for (std::size_t k = 0; k < masses_.size(); ++k) base_[k].add(species_change(y, k));
  bool lacks = false;
  for (std::size_t k = 0; k < masses_.size(); ++k) {
    const double left = std::min(0.0, base_[k].value());
    y[k] += left;
    lacks = lacks || left < 0.0;
  }
  if (lacks) close_streams(y);
  keep_masses_non_negative();
  base_.back().add(energy_change(y));
  for (std::size_t i = 0; i < totals_.size(); ++i) totals_[i].add(y[i]);
  base_time_ = t;
}

void FlowBalance::close_streams(Vector& y) const {
  double species = 0.0, out = 0.0;
  for (std::size_t k = 0; k < masses_.size(); ++k) species += y[k];
  for (std::size_t s = 0; s < streams(); ++s) out += y[out_slot(s)];
  if (!(out > 0.0)) return;
  for (std::size_t s = 0; s < streams(); ++s) y[out_slot(s)] *= species / out;
}

double FlowBalance::stop_reversed_streams(Vector& y, Vector& error) const {
  double out = 0.0, reversed = 0.0;
  for (std::size_t s = 0; s < streams(); ++s) out += y[out_slot(s)];
  const auto stop = [&](std::size_t i) {
    error[i] += y[i];
    y[i] = 0.0;
  };
  if (out < 0.0) {
    reversed = -out;
    for (std::size_t k = 0; k < masses_.size(); ++k) stop(k);
    for (std::size_t s = 0; s < streams(); ++s)
      for (const std::size_t i : {out_slot(s), out_slot(s) + 1}) stop(i);
  }
  for (std::size_t j = 0; j < backflows(); ++j)
    if (const double back = y[back_slot(j)]; back < 0.0) {
      reversed -= back;
      stop(back_slot(j));
    }
  return reversed;
}

double FlowBalance::species_change(const Vector& y, std::size_t k) const {
  double change = -y[k];
  for (std::size_t j = 0; j < backflows(); ++j) change += model_.ambient.mass_fractions[k] * y[back_slot(j)];
  return change;
}

double FlowBalance::energy_change(const Vector& y) const {
  double change = -y[work_slot()] - y[heat_slot()];
  for (std::size_t s = 0; s < streams(); ++s) change -= y[out_slot(s) + 1];
  for (std::size_t j = 0; j < backflows(); ++j) change += air_enthalpy_ * y[back_slot(j)];
  return change;
}

/// Fills masses_ and energy_ with the gas of the sub-step's begin and what has flowed in since.
void FlowBalance::supply(double t) {
  for (std::size_t k = 0; k < masses_.size(); ++k) masses_[k] = base_[k].value();
  energy_ = base_.back().value();
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const auto [mass, enthalpy] = segments_[i].delivered(base_time_, t);
    for (std::size_t k = 0; k < masses_.size(); ++k) masses_[k] += model_.inflows[i].mass_fractions[k] * mass;
    energy_ += enthalpy;
  }
  point_.depleted.reset();
}

/// The gas at time t, (G.9), (G.10).
void FlowBalance::collect(const Vector& y, double t) {
  supply(t);
  for (std::size_t k = 0; k < masses_.size(); ++k) {
    for (std::size_t j = 0; j < backflows(); ++j)
      masses_[k] += model_.ambient.mass_fractions[k] * y[back_slot(j)];
    const double available = masses_[k];
    masses_[k] = std::max(0.0, available - y[k]);
    lack_[k] = y[k] <= available * (1.0 + kMassRoundOff) ? 0.0 : y[k] - available;
  }
  energy_ += energy_change(y);
  find_depleted();
}

/// A species of which more has left than can be overlooked.
void FlowBalance::find_depleted() {
  point_.depleted.reset();
  if (std::ranges::none_of(lack_, [](double lack) { return lack != 0.0; })) return;
  const double allowed = negligible_ * std::accumulate(masses_.begin(), masses_.end(), 0.0);
  for (std::size_t k = 0; k < masses_.size(); ++k)
    if (!(lack_[k] <= allowed)) point_.depleted = k;
}

void FlowBalance::locate(const Vector& y, double t) {
  collect(y, t);
  find_point(t);
}

void FlowBalance::locate_gas(const Gas& gas, double t) {
  double mass = 0.0;
  for (std::size_t k = 0; k < masses_.size(); ++k) mass += masses_[k] = std::max(0.0, gas[k]);
  for (std::size_t k = 0; k < masses_.size(); ++k) lack_[k] = gas[k] >= -kMassRoundOff * mass ? 0.0 : -gas[k];
  find_depleted();
  energy_ = gas.back();
  find_point(t);
}

double FlowBalance::pressure(double t) {
  base_time_ = segment_begin_ = t;
  supply(t);
  find_point(t);
  return point_.pressure;
}

void FlowBalance::gas_begin(Gas& gas) const {
  for (std::size_t i = 0; i < gas.size(); ++i) gas[i] = base_[i].value();
}

void FlowBalance::gas_change(const Vector& y, Gas& change) const {
  for (std::size_t k = 0; k < masses_.size(); ++k) change[k] = species_change(y, k);
  change.back() = energy_change(y);
}

void FlowBalance::add_inflow_rates(double factor, double t, Gas& rates) const {
  for (std::size_t i = 0; i < segments_.size(); ++i) add_stream(i, factor, segments_[i].rate(t), rates);
}

void FlowBalance::add_inflow_slopes(double factor, double t, Gas& slopes) const {
  for (std::size_t i = 0; i < segments_.size(); ++i)
    add_stream(i, factor, segments_[i].rate_slope(t), slopes);
}

/// Adds to `gas` factor times what inflow i brings.
void FlowBalance::add_stream(std::size_t i, double factor, const InflowSegment::Delivered& stream,
                             Gas& gas) const {
  for (std::size_t k = 0; k < masses_.size(); ++k)
    gas[k] += factor * stream.mass * model_.inflows[i].mass_fractions[k];
  gas.back() += factor * stream.enthalpy;
}

}  // namespace gas
