// SPDX-License-Identifier: Apache-2.0
#include "flow_balance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gas/orifice.hpp"

namespace gas {
namespace {

// A species that runs out leaves a remainder of round-off, of either sign, relative to what passed through.
constexpr double kMassRoundOff = 1e-13;

}  // namespace

FlowBalance::FlowBalance(const ControlVolumeModel& model)
    : model_(model),
      openings_(model),
      segments_(model.inflows.size()),
      delivered_(model.inflows.size()),
      masses_(model.thermo.size()) {
  for (const Inflow& inflow : model.inflows)
    inflow_gas_.push_back(model.thermo.mixture(inflow.mass_fractions));
  if (!openings_.any_backflow()) return;
  air_ = model.thermo.mixture(model.ambient.mass_fractions);
  air_enthalpy_ = air_.enthalpy(model.ambient.temperature) / air_.mass;
  air_gamma_ = air_.cp(model.ambient.temperature) / air_.cv(model.ambient.temperature);
}

std::vector<double> FlowBalance::levels() const {
  std::vector<double> levels = openings_.knots();
  for (double& level : levels) level += model_.ambient.pressure;
  return levels;
}

void FlowBalance::begin_step(const ControlVolumeState& state, double t0, double t1, const VolumePath& path) {
  start_ = &state;
  t0_ = t0;
  t1_ = t1;
  volume_begin_ = path.volume_begin;
  mean_rate_ = (path.volume_end - path.volume_begin) / (t1 - t0);
  curvature_ = 4.0 * path.volume_bulge / ((t1 - t0) * (t1 - t0));
  leak_area_begin_ = path.leak_area_begin;
  leak_area_rate_ = (path.leak_area_end - path.leak_area_begin) / (t1 - t0);
  std::ranges::fill(delivered_, StreamFlux{});
  point_.temperature = state.temperature;
}

double FlowBalance::next_break(const TriggerState& triggers, double t) const {
  double next = openings_.next_break(triggers, t);
  for (std::size_t i = 0; i < inflow_gas_.size(); ++i) {
    const Inflow& inflow = model_.inflows[i];
    next =
        std::min(next, gas::next_break(inflow, firing_time(inflow, triggers), inflow_gas_[i].constant_cp, t));
  }
  return next;
}

void FlowBalance::begin_segment(const TriggerState& triggers, double a, double b) {
  segment_begin_ = a;
  openings_.begin_segment(triggers, a, b);
  for (std::size_t i = 0; i < segments_.size(); ++i)
    segments_[i] =
        InflowSegment(model_.inflows[i], firing_time(model_.inflows[i], triggers), inflow_gas_[i], a, b);
}

void FlowBalance::end_segment(double reached) {
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const auto [mass, enthalpy] = segments_[i].delivered_until(reached);
    delivered_[i].mass += mass;
    delivered_[i].enthalpy += enthalpy;
    segments_[i] = InflowSegment();
  }
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

double FlowBalance::species_energy(std::size_t k) const {
  return point_.mass == 0.0 ? 0.0 : model_.thermo.internal_energy(k, point_.temperature);
}

/// Fills masses_, at time t, and returns the internal energy there. (G.9), (G.10)
double FlowBalance::collect(const Vector& y, double t) {
  double energy = start_->internal_energy;
  std::ranges::copy(start_->masses, masses_.begin());
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const auto delivered = segments_[i].delivered(t - segment_begin_);
    energy += delivered_[i].enthalpy + delivered.enthalpy;
    const double mass = delivered_[i].mass + delivered.mass;
    for (std::size_t k = 0; k < masses_.size(); ++k) masses_[k] += model_.inflows[i].mass_fractions[k] * mass;
  }
  point_.depleted.reset();
  for (std::size_t k = 0; k < masses_.size(); ++k) {
    for (std::size_t j = 0; j < backflows(); ++j)
      masses_[k] += model_.ambient.mass_fractions[k] * y[back_slot(j)];
    const double available = masses_[k];
    masses_[k] = std::max(0.0, available - y[k]);
    if (!(y[k] <= available * (1.0 + kMassRoundOff))) point_.depleted = k;
  }
  point_.valid = !point_.depleted;
  return energy + energy_change(y);
}

/// Temperature and pressure, (G.8); no gas has neither energy nor pressure.
void FlowBalance::locate(const Vector& y, double t) {
  const double internal_energy = collect(y, t);
  model_.thermo.mixture(masses_, mixture_);
  point_.mass = mixture_.mass;
  point_.volume = volume(t);
  point_.pressure = point_.gamma = point_.thermal_energy = point_.specific_enthalpy = 0.0;
  point_.heat = 0.0;
  if (!point_.valid || mixture_.mass == 0.0) return;
  const auto temperature = mixture_.find_temperature(internal_energy, point_.temperature);
  point_.valid = temperature.has_value();
  if (!temperature) return;
  const double cp = mixture_.cp(*temperature), cv = cp - mixture_.gas_constant_sum;
  point_.temperature = *temperature;
  point_.pressure = mixture_.gas_constant_sum * *temperature / point_.volume;
  point_.gamma = cp / cv;
  point_.thermal_energy = cv * *temperature;
  point_.heat = model_.heat_loss.conductance * (*temperature - model_.heat_loss.outside_temperature);
  point_.specific_enthalpy = (internal_energy + mixture_.gas_constant_sum * *temperature) / mixture_.mass;
}

double FlowBalance::pressure(const Vector& y, double t) {
  segment_begin_ = t;
  locate(y, t);
  return point_.pressure;
}

void FlowBalance::outflow_rates(Vector& dydt, double t) {
  const double r = mixture_.gas_constant_sum / point_.mass, p = point_.pressure, p_a = ambient_pressure();
  const double flux = regime_ == Regime::kOutSonic
                          ? choked_mass_flow(1.0, p, point_.temperature, r, point_.gamma)
                          : subsonic_mass_flow(1.0, p, point_.temperature, r,
                                               r * point_.gamma / (point_.gamma - 1.0), point_.gamma, p_a);
  for (std::size_t j = 0; j < openings_.vents(); ++j) {
    const double flow = openings_.effective_area(j, t, p - p_a) * flux;
    dydt[out_slot(j)] = flow;
    dydt[out_slot(j) + 1] = flow * point_.specific_enthalpy;
    point_.vent += flow;
  }
  const double density = point_.mass / point_.volume;
  point_.fabric = model_.fabric_velocity && p > p_a
                      ? leak_area(t) * density * openings_.fabric_velocity(p - p_a)
                      : fabric_mass_flow(leak_area(t), density, p, p_a);
  const std::size_t fabric = out_slot(openings_.vents());
  dydt[fabric] = point_.fabric;
  dydt[fabric + 1] = point_.fabric * point_.specific_enthalpy;
  const double per_mass = (point_.vent + point_.fabric) / point_.mass;
  for (std::size_t k = 0; k < masses_.size(); ++k) dydt[k] = per_mass * masses_[k];
}

void FlowBalance::backflow_rates(Vector& dydt, double t) {
  const double p_a = ambient_pressure(), t_a = model_.ambient.temperature,
               r = air_.gas_constant_sum / air_.mass;
  const double flux = regime_ == Regime::kBackSonic
                          ? choked_mass_flow(1.0, p_a, t_a, r, air_gamma_)
                          : subsonic_mass_flow(1.0, p_a, t_a, r, r * air_gamma_ / (air_gamma_ - 1.0),
                                               air_gamma_, point_.pressure);
  for (std::size_t j = 0; j < openings_.vents(); ++j) {
    if (!openings_.has_backflow(j)) continue;
    dydt[back_slot(j)] = openings_.effective_area(j, t, point_.pressure - p_a) * flux;
    point_.back += dydt[back_slot(j)];
  }
}

void FlowBalance::fill_rates(Vector& dydt, double t) {
  std::ranges::fill(dydt, 0.0);
  point_.vent = point_.fabric = point_.back = 0.0;
  if (!point_.valid) return;
  if (regime_ == Regime::kBack || regime_ == Regime::kBackSonic) backflow_rates(dydt, t);
  dydt[heat_slot()] = point_.heat;
  if (point_.mass == 0.0) return;
  dydt[work_slot()] = point_.pressure * volume_rate(t);
  if (regime_ == Regime::kOut || regime_ == Regime::kOutSonic) outflow_rates(dydt, t);
}

bool FlowBalance::is_open() const {
  return openings_.is_open() || leak_area_begin_ > 0.0 || leak_area_rate_ != 0.0;
}

bool FlowBalance::has_backflow() const {
  return openings_.any_backflow() && openings_.is_open();
}

bool FlowBalance::needs_stepper() const {
  return is_open() || mean_rate_ != 0.0 || curvature_ != 0.0 || model_.heat_loss.conductance > 0.0;
}

double FlowBalance::pressure_excess() const {
  return point_.pressure - model_.ambient.pressure;
}

double FlowBalance::sonic_excess() const {
  if (point_.mass == 0.0) return -model_.ambient.pressure;
  return critical_pressure_ratio(point_.gamma) * point_.pressure - model_.ambient.pressure;
}

double FlowBalance::back_sonic_excess() const {
  return point_.pressure - critical_pressure_ratio(air_gamma_) * model_.ambient.pressure;
}

void FlowBalance::finish(const Vector& y, ControlVolumeState& state) {
  const double internal_energy = collect(y, segment_begin_);
  model_.thermo.mixture(masses_, mixture_);
  if (mixture_.mass > 0.0) state.temperature = mixture_.temperature(internal_energy, point_.temperature);
  state.internal_energy = internal_energy;
  std::ranges::copy(masses_, state.masses.begin());
}

}  // namespace gas
