// SPDX-License-Identifier: Apache-2.0
#include "flow_balance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gas/orifice.hpp"

namespace gas {
FlowBalance::FlowBalance(const ControlVolumeModel& model, double negligible)
    : model_(model),
      negligible_(negligible),
      openings_(model),
      segments_(model.inflows.size()),
      delivered_(model.inflows.size()),
      received_(model.inflows.size()),
      masses_(model.thermo.size()),
      lack_(masses_.size()),
      base_(masses_.size() + 1),
      totals_(unknowns()),
      scratch_(unknowns()) {
  if (model.volume_of_overpressure)
    volume_by_pressure_.emplace(*model.volume_of_overpressure, model.ambient.pressure);
  for (const Inflow& inflow : model.inflows)
    inflow_gas_.push_back(model.thermo.mixture(inflow.mass_fractions));
  if (!openings_.any_backflow()) return;
  air_ = model.thermo.mixture(model.ambient.mass_fractions);
  air_enthalpy_ = air_.enthalpy(model.ambient.temperature) / air_.mass;
  air_gamma_ = air_.cp(model.ambient.temperature) / air_.cv(model.ambient.temperature);
}

std::vector<double> FlowBalance::levels() const {
  std::vector<double> levels = openings_.knots();
  if (model_.volume_of_overpressure)
    for (const Curve::Knot& knot : model_.volume_of_overpressure->knots()) levels.push_back(knot.time);
  return levels;
}

void FlowBalance::begin_step(const ControlVolumeState& state, double t0, double t1, const VolumePath& path) {
  begin_books(state);
  t0_ = t0;
  t1_ = t1;
  volume_begin_ = path.volume_begin;
  mean_rate_ = (path.volume_end - path.volume_begin) / (t1 - t0);
  curvature_ = 4.0 * path.volume_bulge / ((t1 - t0) * (t1 - t0));
  leak_area_begin_ = path.leak_area_begin;
  leak_area_rate_ = (path.leak_area_end - path.leak_area_begin) / (t1 - t0);
  point_.temperature = state.temperature;
  work_begin_ = 0.0;
  if (!volume_by_pressure_) return;
  volume_by_pressure_->leave_piece();
  mean_rate_ = curvature_ = 0.0;
  model_.thermo.mixture(state.masses, mixture_);
  if (mixture_.mass == 0.0) return;
  place_gas(state.internal_energy, mixture_.temperature(state.internal_energy, state.temperature));
  work_begin_ = point_.work;
}

void FlowBalance::enter_band(double overpressure) {
  openings_.enter_band(overpressure);
  if (volume_by_pressure_) volume_by_pressure_->enter_piece(overpressure);
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
  segment_begin_ = base_time_ = a;
  openings_.begin_segment(triggers, a, b);
  for (std::size_t i = 0; i < segments_.size(); ++i)
    segments_[i] =
        InflowSegment(model_.inflows[i], firing_time(model_.inflows[i], triggers), inflow_gas_[i], a, b);
}

double FlowBalance::species_energy(std::size_t k) const {
  if (point_.mass == 0.0) return 0.0;
  return model_.thermo.internal_energy(k, point_.temperature) +
         work_share_ * model_.thermo.gas_constant(k) * point_.temperature;
}

/// At p_a + overpressure, as is backflow_rates().
void FlowBalance::outflow_rates(Vector& dydt, double t, double overpressure) {
  const double r = mixture_.gas_constant_sum / point_.mass, p = ambient_pressure() + overpressure;
  const double flux =
      regime_ == Regime::kOutSonic
          ? choked_mass_flow(1.0, p, point_.temperature, r, point_.gamma)
          : subsonic_mass_flow(1.0, p, point_.temperature, r, r * point_.gamma / (point_.gamma - 1.0),
                               point_.gamma, overpressure);
  for (std::size_t j = 0; j < openings_.vents(); ++j) {
    const double flow = openings_.effective_area(j, t, overpressure) * flux;
    dydt[out_slot(j)] = flow;
    dydt[out_slot(j) + 1] = flow * point_.specific_enthalpy;
    point_.vent += flow;
  }
  const double density = point_.mass / point_.volume;
  point_.fabric = model_.fabric_velocity && overpressure > 0.0
                      ? leak_area(t) * density * openings_.fabric_velocity(overpressure)
                      : fabric_mass_flow(leak_area(t), density, overpressure);
  const std::size_t fabric = out_slot(openings_.vents());
  dydt[fabric] = point_.fabric;
  dydt[fabric + 1] = point_.fabric * point_.specific_enthalpy;
  const double per_mass = (point_.vent + point_.fabric) / point_.mass;
  for (std::size_t k = 0; k < masses_.size(); ++k) dydt[k] = per_mass * masses_[k];
}

void FlowBalance::backflow_rates(Vector& dydt, double t, double overpressure) {
  const double p_a = ambient_pressure(), t_a = model_.ambient.temperature,
               r = air_.gas_constant_sum / air_.mass;
  const double flux = regime_ == Regime::kBackSonic
                          ? choked_mass_flow(1.0, p_a, t_a, r, air_gamma_)
                          : subsonic_mass_flow(1.0, p_a, t_a, r, r * air_gamma_ / (air_gamma_ - 1.0),
                                               air_gamma_, -overpressure);
  for (std::size_t j = 0; j < openings_.vents(); ++j) {
    if (!openings_.has_backflow(j)) continue;
    dydt[back_slot(j)] = openings_.effective_area(j, t, overpressure) * flux;
    point_.back += dydt[back_slot(j)];
  }
}

void FlowBalance::fill_rates(Vector& dydt, double t) {
  std::ranges::fill(dydt, 0.0);
  point_.vent = point_.fabric = point_.back = 0.0;
  if (!point_.valid) return;
  if (regime_ == Regime::kBack || regime_ == Regime::kBackSonic) backflow_rates(dydt, t, point_.overpressure);
  dydt[heat_slot()] = point_.heat;
  if (point_.mass == 0.0) return;
  dydt[work_slot()] = point_.pressure * volume_rate(t);
  if (regime_ == Regime::kOut || regime_ == Regime::kOutSonic) outflow_rates(dydt, t, point_.overpressure);
  if (is_held()) hold(dydt, t);
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

double FlowBalance::sonic_excess() const {
  if (point_.mass == 0.0) return -model_.ambient.pressure;
  return critical_pressure_ratio(point_.gamma) * point_.pressure - model_.ambient.pressure;
}

double FlowBalance::back_sonic_excess() const {
  return point_.pressure - critical_pressure_ratio(air_gamma_) * model_.ambient.pressure;
}

}  // namespace gas
