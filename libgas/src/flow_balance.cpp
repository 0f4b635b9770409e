// SPDX-License-Identifier: Apache-2.0
#include "flow_balance.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "gas/orifice.hpp"

namespace gas {
namespace {

// A species that runs out leaves a remainder of round-off, of either sign, relative to what passed through.
constexpr double kMassRoundOff = 1e-13;

}  // namespace

FlowBalance::FlowBalance(const ControlVolumeModel& model)
    : model_(model),
      segments_(model.inflows.size()),
      delivered_(model.inflows.size()),
      masses_(model.thermo.size()) {
  for (const Inflow& inflow : model.inflows)
    inflow_gas_.push_back(model.thermo.mixture(inflow.mass_fractions));
  for (const Orifice& vent : model.vents) vent_area_ += vent.discharge_coefficient * vent.area;
}

void FlowBalance::begin_step(const ControlVolumeState& state, double t0, double t1, const VolumePath& path) {
  start_ = &state;
  t0_ = t0;
  volume_begin_ = path.volume_begin;
  volume_rate_ = (path.volume_end - path.volume_begin) / (t1 - t0);
  leak_area_begin_ = path.leak_area_begin;
  leak_area_rate_ = (path.leak_area_end - path.leak_area_begin) / (t1 - t0);
  std::ranges::fill(delivered_, 0.0);
  enthalpy_in_ = 0.0;
  point_.temperature = state.temperature;
}

double FlowBalance::next_break(double t) const {
  double next = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < inflow_gas_.size(); ++i)
    next = std::min(next, gas::next_break(model_.inflows[i], inflow_gas_[i].constant_cp, t));
  return next;
}

void FlowBalance::begin_segment(double a, double b) {
  segment_begin_ = a;
  for (std::size_t i = 0; i < segments_.size(); ++i)
    segments_[i] = InflowSegment(model_.inflows[i], inflow_gas_[i], a, b);
}

void FlowBalance::end_segment() {
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const auto [mass, enthalpy] = segments_[i].total();
    delivered_[i] += mass;
    enthalpy_in_ += enthalpy;
    segments_[i] = InflowSegment();
  }
}

double FlowBalance::mass_in() const {
  return std::accumulate(delivered_.begin(), delivered_.end(), 0.0);
}

/// Fills masses_ and returns the enthalpy delivered since t0. (G.9)
double FlowBalance::collect(const Vector& y, double elapsed) {
  double enthalpy = enthalpy_in_;
  std::ranges::copy(start_->masses, masses_.begin());
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const auto delivered = segments_[i].delivered(elapsed);
    enthalpy += delivered.enthalpy;
    const double mass = delivered_[i] + delivered.mass;
    for (std::size_t k = 0; k < masses_.size(); ++k) masses_[k] += model_.inflows[i].mass_fractions[k] * mass;
  }
  point_.valid = true;
  for (std::size_t k = 0; k < masses_.size(); ++k) {
    const double available = masses_[k];
    masses_[k] = std::max(0.0, available - y[k]);
    if (!(y[k] <= available * (1.0 + kMassRoundOff))) point_.valid = false;
  }
  return enthalpy;
}

/// Temperature and pressure, (G.8); no gas has neither energy nor pressure.
void FlowBalance::locate_point(double internal_energy, double t) {
  model_.thermo.mixture(masses_, mixture_);
  point_.mass = mixture_.mass;
  point_.volume = volume(t);
  point_.pressure = point_.gamma = point_.thermal_energy = point_.specific_enthalpy = 0.0;
  if (!point_.valid || mixture_.mass == 0.0) return;
  const auto temperature = mixture_.find_temperature(internal_energy, point_.temperature);
  point_.valid = temperature.has_value();
  if (!temperature) return;
  const double cp = mixture_.cp(*temperature), cv = cp - mixture_.gas_constant_sum;
  point_.temperature = *temperature;
  point_.pressure = mixture_.gas_constant_sum * *temperature / point_.volume;
  point_.gamma = cp / cv;
  point_.thermal_energy = cv * *temperature;
  point_.specific_enthalpy = (internal_energy + mixture_.gas_constant_sum * *temperature) / mixture_.mass;
}

void FlowBalance::outflow_rates(Vector& dydt, double t) const {
  const double r = mixture_.gas_constant_sum / point_.mass;
  const double vent = regime_ == Regime::kChoked
                          ? choked_mass_flow(vent_area_, point_.pressure, point_.temperature, r, point_.gamma)
                          : subsonic_mass_flow(vent_area_, point_.pressure, point_.temperature, r,
                                               r * point_.gamma / (point_.gamma - 1.0), point_.gamma,
                                               model_.ambient.pressure);
  const double fabric =
      fabric_mass_flow(leak_area(t), point_.mass / point_.volume, point_.pressure, model_.ambient.pressure);
  const double per_mass = (vent + fabric) / point_.mass;
  for (std::size_t k = 0; k < masses_.size(); ++k) dydt[k] = per_mass * masses_[k];
  dydt[enthalpy_slot()] = (vent + fabric) * point_.specific_enthalpy;
  dydt[vent_slot()] = vent;
  dydt[fabric_slot()] = fabric;
}

void FlowBalance::operator()(const Vector& y, Vector& dydt, double t) {
  const double enthalpy = collect(y, t - segment_begin_);
  locate_point(start_->internal_energy + enthalpy - y[enthalpy_slot()] - y[work_slot()], t);
  std::ranges::fill(dydt, 0.0);
  if (!point_.valid || point_.mass == 0.0) return;
  dydt[work_slot()] = point_.pressure * volume_rate_;
  if (regime_ != Regime::kClosed) outflow_rates(dydt, t);
}

bool FlowBalance::is_open() const {
  return vent_area_ > 0.0 || leak_area_begin_ > 0.0 || leak_area_rate_ > 0.0;
}

double FlowBalance::pressure_excess() const {
  return point_.pressure - model_.ambient.pressure;
}

double FlowBalance::sonic_excess() const {
  if (point_.mass == 0.0) return -model_.ambient.pressure;
  return critical_pressure_ratio(point_.gamma) * point_.pressure - model_.ambient.pressure;
}

double FlowBalance::closed_pressure_growth(double t) const {
  double growth = -point_.gamma * point_.pressure * volume_rate_;
  for (const InflowSegment& segment : segments_) {
    const auto [mass_flow, temperature] = segment.flow(t - segment_begin_);
    if (mass_flow == 0.0) continue;
    const Mixture& gas = segment.gas();
    growth += mass_flow *
              (gas.gas_constant_sum * point_.temperature +
               (point_.gamma - 1.0) * (gas.enthalpy(temperature) - gas.internal_energy(point_.temperature)));
  }
  return growth;
}

double FlowBalance::pressure_rate(const Vector& dydt, double t) const {
  if (point_.mass == 0.0) return 0.0;
  const double gas_constant = mixture_.gas_constant_sum / point_.mass;
  const double loss =
      point_.gamma * gas_constant * point_.temperature * (dydt[vent_slot()] + dydt[fabric_slot()]);
  return (closed_pressure_growth(t) - loss) / point_.volume;
}

void FlowBalance::finish(const Vector& y, ControlVolumeState& state) {
  const double enthalpy = collect(y, 0.0);
  const double internal_energy = state.internal_energy + enthalpy - y[enthalpy_slot()] - y[work_slot()];
  model_.thermo.mixture(masses_, mixture_);
  if (mixture_.mass > 0.0) state.temperature = mixture_.temperature(internal_energy, point_.temperature);
  state.internal_energy = internal_energy;
  std::ranges::copy(masses_, state.masses.begin());
}

}  // namespace gas
