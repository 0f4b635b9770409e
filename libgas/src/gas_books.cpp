// SPDX-License-Identifier: Apache-2.0
// FlowBalance: what the gas holds. It is carried from sub-step to sub-step, not as what it held at the step's
// begin less what has passed since: through a tiny volume that is so much more that the difference would be
// rounding.
#include <algorithm>

#include "flow_balance.hpp"
#include "infinity.hpp"

namespace gas {
void FlowBalance::begin_books(const ControlVolumeState& state) {
  for (std::size_t k = 0; k < masses_.size(); ++k) base_[k] = state.masses[k];
  base_.back() = state.internal_energy;
  std::ranges::fill(totals_, CompensatedSum{});
  std::ranges::fill(delivered_, StreamFlux{});
  std::ranges::fill(received_, StreamFlux{});
}

void FlowBalance::end_segment(double reached) {
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const auto [mass, enthalpy] = segments_[i].delivered_until(reached);
    add_rest(i, {mass - received_[i].mass, enthalpy - received_[i].enthalpy});
    delivered_[i].mass += mass;
    delivered_[i].enthalpy += enthalpy;
    received_[i] = {};
    segments_[i] = InflowSegment();
  }
  coming_time_ = kInfinity;
  if (volume_by_pressure_) volume_by_pressure_->leave_piece();
}

/// What came through inflow i besides received_: all of it, or what sub-steps' times rounded off. The latter
/// leaves again where twice what there is has come in, of which most has left.
void FlowBalance::add_rest(std::size_t i, const StreamFlux& rest) {
  double there = 0.0, out = 0.0;
  for (std::size_t k = 0; k < masses_.size(); ++k) there += base_[k].value();
  for (std::size_t s = 0; s < streams(); ++s) out += total(out_slot(s));
  const bool leaves = received_[i].mass > 2.0 * there && out > 0.0;
  for (std::size_t k = 0; k < masses_.size(); ++k)
    (leaves ? totals_ : base_)[k].add(model_.inflows[i].mass_fractions[k] * rest.mass);
  if (!leaves) base_.back().add(rest.enthalpy);
  for (std::size_t s = 0; s < streams() && leaves; ++s) {
    const double share = total(out_slot(s)) / out;
    totals_[out_slot(s)].add(share * rest.mass);
    totals_[out_slot(s) + 1].add(share * rest.enthalpy);
  }
}

/// Fills coming_.
void FlowBalance::deliver(double t) {
  if (t == coming_time_) return;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const auto [mass, enthalpy] = segments_[i].delivered(base_time_ - segment_begin_, t - segment_begin_);
    coming_[i] = {mass, enthalpy};
  }
  coming_time_ = t;
}

void FlowBalance::accept(Vector& y, const Gas& change, double t) {
  deliver(t);
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    received_[i].mass += coming_[i].mass;
    received_[i].enthalpy += coming_[i].enthalpy;
  }
  bool gone = false;
  for (std::size_t k = 0; k < masses_.size(); ++k) {
    base_[k].add(change[k]);
    if (const double left = base_[k].value(); left < 0.0) {
      y[k] += left;
      base_[k] = 0.0;
      gone = true;
    }
  }
  if (gone) close_streams(y);
  base_.back().add(change.back());
  for (std::size_t i = 0; i < totals_.size(); ++i) totals_[i].add(y[i]);
  base_time_ = t;
  coming_time_ = kInfinity;
}

/// Makes what leaves in all streams the mass of what leaves of all species.
void FlowBalance::close_streams(Vector& y) const {
  double species = 0.0, out = 0.0;
  for (std::size_t k = 0; k < masses_.size(); ++k) species += y[k];
  for (std::size_t s = 0; s < streams(); ++s) out += y[out_slot(s)];
  if (!(out > 0.0)) return;
  for (std::size_t s = 0; s < streams(); ++s) y[out_slot(s)] *= species / out;
}

void FlowBalance::reconcile(Vector& y, Gas& change, double t) {
  whole_change(y, t, scratch_gas_);
  double in = 0.0, out = 0.0, left = 0.0;
  for (const StreamFlux& inflow : coming_) in += inflow.mass;
  for (std::size_t k = 0; k < masses_.size(); ++k) out += y[k];
  const bool passes = out > 0.5 * in;
  for (std::size_t k = 0; k < masses_.size(); ++k) {
    const double more = scratch_gas_[k] - change[k];
    (passes ? y[k] : change[k]) += more;
  }
  close_streams(y);
  for (std::size_t s = 0; s < streams(); ++s) left += y[out_slot(s)];
  const double more = scratch_gas_.back() - change.back();
  if (passes && left > 0.0)
    for (std::size_t s = 0; s < streams(); ++s) y[out_slot(s) + 1] += more * y[out_slot(s)] / left;
  else if (has_walls())
    y[heat_slot()] += more;
  else
    change.back() += more;
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
  deliver(t);
  for (std::size_t k = 0; k < masses_.size(); ++k) masses_[k] = base_[k].value();
  energy_ = base_.back().value();
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    for (std::size_t k = 0; k < masses_.size(); ++k)
      masses_[k] += model_.inflows[i].mass_fractions[k] * coming_[i].mass;
    energy_ += coming_[i].enthalpy;
  }
  point_.depleted.reset();
}

/// Species that masses_ lacks by more than is negligible; the others are not negative.
void FlowBalance::find_depleted() {
  double mass = 0.0;
  for (const double m : masses_) mass += std::max(0.0, m);
  point_.depleted.reset();
  for (std::size_t k = 0; k < masses_.size(); ++k) {
    if (!(masses_[k] >= -negligible_ * mass)) point_.depleted = k;
    masses_[k] = std::max(0.0, masses_[k]);
  }
}

/// The gas at time t, (G.9), (G.10).
void FlowBalance::collect(const Vector& y, double t) {
  supply(t);
  for (std::size_t k = 0; k < masses_.size(); ++k) masses_[k] += species_change(y, k);
  energy_ += energy_change(y);
  find_depleted();
}

void FlowBalance::locate(const Vector& y, double t) {
  collect(y, t);
  find_point(t);
}

void FlowBalance::locate_gas(const Gas& gas, double t) {
  std::copy(gas.begin(), gas.end() - 1, masses_.begin());
  energy_ = gas.back();
  find_depleted();
  find_point(t);
}

void FlowBalance::locate_change(const Gas& change, double t) {
  for (std::size_t i = 0; i < change.size(); ++i) scratch_gas_[i] = base_[i].value() + change[i];
  locate_gas(scratch_gas_, t);
}

double FlowBalance::pressure(double t) {
  base_time_ = segment_begin_ = t;
  coming_time_ = kInfinity;
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

void FlowBalance::whole_change(const Vector& y, double t, Gas& change) {
  deliver(t);
  gas_change(y, change);
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    for (std::size_t k = 0; k < masses_.size(); ++k)
      change[k] += model_.inflows[i].mass_fractions[k] * coming_[i].mass;
    change.back() += coming_[i].enthalpy;
  }
}

void FlowBalance::add_inflow_rates(double factor, double t, Gas& rates) const {
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const auto [mass_flow, temperature] = segments_[i].flow(t - segment_begin_);
    if (mass_flow == 0.0) continue;
    for (std::size_t k = 0; k < masses_.size(); ++k)
      rates[k] += factor * mass_flow * model_.inflows[i].mass_fractions[k];
    rates.back() += factor * mass_flow * segments_[i].gas().enthalpy(temperature);
  }
}

}  // namespace gas
