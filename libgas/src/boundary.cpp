// SPDX-License-Identifier: Apache-2.0
#include "boundary.hpp"

#include <algorithm>
#include <cmath>

namespace gas {
namespace {

bool lets_air_in(const ControlVolumeModel& model) {
  return std::ranges::any_of(model.vents, &Vent::backflow);
}

}  // namespace

double laminar_overpressure(const ControlVolumeModel& model) {
  return model.laminar_share * model.ambient.pressure;
}

const Fabric& fabric_of(const ControlVolumeModel& model, std::size_t i) {
  static const Fabric whole{1.0};
  return model.fabrics.empty() ? whole : model.fabrics[i];
}

double fabric_flow(const ControlVolumeModel& model, std::size_t i, double leak_area, const UniformGas& gas) {
  const auto& [share, velocity] = fabric_of(model, i);
  const double area = share * leak_area;
  if (!velocity) return area * fabric_flux(gas.upstream(), laminar_overpressure(model));
  return area * gas.mass / gas.volume * velocity->value(gas.overpressure);
}

double heat_flow(const ControlVolumeModel& model, const UniformGas& gas) {
  return model.heat_loss.conductance * (gas.temperature - model.heat_loss.outside_temperature);
}

AmbientGas::AmbientGas(const ControlVolumeModel& model)
    : pressure(model.ambient.pressure), temperature(model.ambient.temperature) {
  if (!lets_air_in(model)) return;
  mixture = model.thermo.mixture(model.ambient.mass_fractions);
  gas_constant = mixture.gas_constant_sum / mixture.mass;
  gamma = mixture.cp(temperature) / mixture.cv(temperature);
  enthalpy = mixture.enthalpy(temperature) / mixture.mass;
}

Boundary::Boundary(const ControlVolumeModel& model)
    : model_(model),
      ambient_(model),
      slots_{model.thermo.size(), model.vents.size(), model.fabric_count(),
             lets_air_in(model) ? model.vents.size() : 0},
      laminar_(laminar_overpressure(model)),
      inflows_(model),
      openings_(model) {}

void Boundary::begin_step(double t0, double t1, const VolumePath& path) {
  const double length = t1 - t0;
  path_ = {t0,
           t1,
           path.volume_begin,
           (path.volume_end - path.volume_begin) / length,
           4.0 * path.volume_bulge / (length * length),
           path.leak_area_begin,
           (path.leak_area_end - path.leak_area_begin) / length};
  if (model_.volume_of_overpressure) path_.mean_rate = path_.curvature = 0.0;
}

void Boundary::begin_segment(const TriggerState& triggers, double a, double b) {
  openings_.begin_segment(triggers, a, b);
  inflows_.begin_segment(triggers, a, b);
}

double Boundary::next_break(const TriggerState& triggers, double t) const {
  return std::min(openings_.next_break(triggers, t), inflows_.next_break(triggers, t));
}

double Boundary::out(std::size_t j, const UniformGas& gas, double t) const {
  if (j < slots_.vents) {
    const double area = openings_.effective_area(j, t, gas.overpressure);
    return area == 0.0 ? 0.0 : area * hole_flux(gas.upstream(), laminar_);
  }
  const double area = path_.leak_area(t);
  return area == 0.0 ? 0.0 : fabric_flow(model_, j - slots_.vents, area, gas);
}

double Boundary::back(std::size_t j, const UniformGas& gas, double t) const {
  if (!model_.vents[j].backflow) return 0.0;
  return openings_.effective_area(j, t, gas.overpressure) *
         hole_flux(ambient_.upstream(gas.overpressure), laminar_);
}

Flow Boundary::vent_slopes(std::size_t j, const UniformGas& gas, double t) const {
  const Openings::Area area = openings_.area(j, t, gas.overpressure);
  const double flux = hole_flux(gas.upstream(), laminar_), a = area.value;
  const FluxSlopes by = hole_flux_slopes(gas.upstream(), laminar_);
  return {a * flux,           a * by.upstream + area.by_overpressure * flux,
          a * by.temperature, a * by.gas_constant,
          a * by.gamma,       area.by_time * flux};
}

Flow Boundary::fabric_slopes(std::size_t i, const UniformGas& gas, double t) const {
  if (!path_.leaks()) return {};
  const auto& [share, velocity] = fabric_of(model_, i);
  const double area = share * path_.leak_area(t), flow = out(slots_.fabric(i), gas, t), dp = gas.overpressure;
  const double by_time = area > 0.0 ? flow / area * share * path_.leak_rate : 0.0;
  if (!velocity) {
    const FluxSlopes by = fabric_flux_slopes(gas.upstream(), laminar_);
    return {flow, area * by.upstream, area * by.temperature, area * by.gas_constant, 0.0, by_time};
  }
  return {flow,
          flow / gas.pressure + area * gas.mass / gas.volume * velocity->piece(dp).slope,
          -flow / gas.temperature,
          -flow / gas.gas_constant,
          0.0,
          by_time};
}

Flow Boundary::out_slopes(std::size_t j, const UniformGas& gas, double t) const {
  return j < slots_.vents ? vent_slopes(j, gas, t) : fabric_slopes(j - slots_.vents, gas, t);
}

Flow Boundary::back_slopes(std::size_t j, const UniformGas& gas, double t) const {
  if (!model_.vents[j].backflow) return {};
  const Upstream from = ambient_.upstream(gas.overpressure);
  const Openings::Area area = openings_.area(j, t, gas.overpressure);
  const double flux = hole_flux(from, laminar_);
  return {area.value * flux,
          area.value * hole_flux_slopes(from, laminar_).downstream + area.by_overpressure * flux,
          0.0,
          0.0,
          0.0,
          area.by_time * flux};
}

double growth_per_flow(const Mixture& mixture, double temperature, const UniformGas& gas) {
  return (mixture.gas_constant_sum * gas.temperature +
          (gas.gamma - 1.0) * (mixture.enthalpy(temperature) - mixture.internal_energy(gas.temperature))) /
         mixture.mass;
}

double closed_growth(const Boundary& boundary, const UniformGas& gas, double t) {
  const Inflows& inflows = boundary.inflows();
  double growth = -gas.gamma * gas.pressure * boundary.path().rate(t) -
                  (gas.gamma - 1.0) * heat_flow(boundary.model(), gas);
  for (std::size_t i = 0; i < inflows.size(); ++i) {
    if (inflows[i].is_idle()) continue;
    const auto [mass_flow, temperature] = inflows[i].flow(t);
    growth += mass_flow * growth_per_flow(inflows[i].gas(), temperature, gas);
  }
  return growth / gas.compliance();
}

}  // namespace gas
