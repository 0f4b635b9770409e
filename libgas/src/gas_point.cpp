// SPDX-License-Identifier: Apache-2.0
// The gas and its flows at one moment.
#include <cmath>

#include "boundary.hpp"
#include "gas/control_volume.hpp"
#include "require.hpp"

namespace gas {
namespace {

double mass_flow(const Inflow& inflow, double since, Side side = Side::after) {
  const bool fired = side == Side::after ? since >= 0.0 : since > 0.0;
  return fired ? inflow.mass_flow.value(since, side) : 0.0;
}

InflatorPoint inflator_point(const ControlVolumeModel& model, const Inflow& inflow, double since, Side side) {
  const double temperature = inflow.temperature.value(since, side);
  const Mixture gas = model.thermo.mixture(inflow.mass_fractions);
  const double cp = gas.cp(temperature);
  return {mass_flow(inflow, since, side), temperature, cp / gas.mass, cp / gas.cv(temperature),
          gas.gas_constant_sum / gas.mass};
}

void require_triggers(const ControlVolumeModel& model, const ControlVolumeState& state) {
  require(state.triggers.size() == model.triggers.size(), "number of triggers of the state",
          static_cast<double>(state.triggers.size()),
          "must be one per node of the model's triggers: use make_state(model, ...)");
}

/// The gas of `state`, (G.8), (G.18).
UniformGas gas_of(const ControlVolumeModel& model, const ControlVolumeState& state, double volume) {
  const Mixture mixture = model.thermo.mixture(state.masses);
  const double energy = state.internal_energy + stored_work(model, state);
  UniformGas gas{};
  gas.temperature = state.temperature;
  if (!locate(model, mixture, energy, volume, gas))
    mixture.temperature(state.internal_energy, state.temperature);  // throws the reason
  if (gas.beyond) throw DomainError(beyond_text(model));
  return gas;
}

/// Cd A of a vent [m2]; zero while it is shut.
double effective_area(const Vent& vent, const TriggerState& triggers, double time, double overpressure) {
  if (vent.trigger && !triggers.at(*vent.trigger).on) return 0.0;
  double area = vent.area;
  if (const auto& curve = vent.area_of_overpressure) area = curve->value(overpressure);
  if (const auto& curve = vent.area_of_time)
    area = curve->value(local_time({&*curve}, opened_at(vent, triggers), time));
  return vent.discharge_coefficient * area;
}

}  // namespace

GasPoint evaluate(const ControlVolumeModel& model, const ControlVolumeState& state, double volume,
                  double leak_area, double time) {
  if (!model.volume_of_overpressure && !(volume > 0.0))
    throw DomainError("volume = " + to_short_text(volume) + " m3: must be positive");
  if (!(leak_area >= 0.0 && std::isfinite(leak_area)))
    throw DomainError("leak_area = " + to_short_text(leak_area) + " m2: must be finite and not negative");
  require_triggers(model, state);
  const UniformGas gas = gas_of(model, state, volume);
  GasPoint point{};
  point.pressure = gas.pressure;
  point.temperature = gas.temperature;
  point.volume = gas.volume;
  point.density = gas.mass / gas.volume;
  point.gamma = gas.gamma;
  point.cp = gas.cp;
  point.gas_constant = gas.gas_constant;
  point.mass = gas.mass;
  for (const Inflow& inflow : model.inflows)
    point.inflow += mass_flow(inflow, local_time(inflow, firing_time(inflow, state.triggers), time));
  double area = 0.0, back_area = 0.0;
  for (const Vent& vent : model.vents) {
    const double effective = effective_area(vent, state.triggers, time, gas.overpressure);
    area += effective;
    if (vent.backflow) back_area += effective;
  }
  const double laminar = laminar_overpressure(model);
  if (gas.overpressure > 0.0) {
    point.vent_mass_flow = area * hole_flux(gas.upstream(), laminar);
    for (std::size_t i = 0; i < model.fabric_count(); ++i)
      point.fabric_mass_flow += fabric_flow(model, i, leak_area, gas.upstream());
  } else if (back_area > 0.0) {
    point.backflow = back_area * hole_flux(AmbientGas(model).upstream(gas.overpressure), laminar);
  }
  if (gas.mass > 0.0) point.heat_loss = heat_flow(model, gas.temperature);
  return point;
}

InflatorPoint inflator_point(const ControlVolumeModel& model, const ControlVolumeState& state, std::size_t i,
                             double time) {
  const Inflow& inflow = model.inflows.at(i);
  require_triggers(model, state);
  return inflator_point(model, inflow, local_time(inflow, firing_time(inflow, state.triggers), time),
                        Side::after);
}

InflatorPoint inflator_point(const ControlVolumeModel& model, std::size_t i, double time, Side side) {
  const Inflow& inflow = model.inflows.at(i);
  return inflator_point(model, inflow, local_time(inflow, inflow.start_time, time), side);
}

InflatorPoint inflator_point_since_firing(const ControlVolumeModel& model, std::size_t i, double since,
                                          Side side) {
  return inflator_point(model, model.inflows.at(i), since, side);
}

}  // namespace gas
