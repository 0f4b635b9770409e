// SPDX-License-Identifier: Apache-2.0
// The gas and its flows at one moment.
#include <cmath>

#include "gas/control_volume.hpp"
#include "gas/orifice.hpp"
#include "inflow_segment.hpp"
#include "near.hpp"
#include "pressure_volume.hpp"
#include "require.hpp"

namespace gas {
namespace {

double mass_flow(const Inflow& inflow, double start, double time) {
  const double tau = local_time(inflow, start, time);
  return tau >= 0.0 ? inflow.mass_flow.value(tau) : 0.0;
}

InflatorPoint inflator_point(const ControlVolumeModel& model, const Inflow& inflow, double start,
                             double time) {
  const double temperature = inflow.temperature.value(local_time(inflow, start, time));
  const Mixture gas = model.thermo.mixture(inflow.mass_fractions);
  const double cp = gas.cp(temperature);
  return {mass_flow(inflow, start, time), temperature, cp / gas.mass, cp / gas.cv(temperature),
          gas.gas_constant_sum / gas.mass};
}

double vent_area(const Vent& vent, const TriggerState& triggers, double time, double overpressure) {
  if (vent.trigger && !triggers.at(*vent.trigger).on) return 0.0;
  if (vent.area_of_overpressure) return vent.area_of_overpressure->value(overpressure);
  if (!vent.area_of_time) return vent.area;
  return vent.area_of_time->value(time - (vent.trigger ? triggers[*vent.trigger].since : 0.0));
}

/// Flows through the openings at `point`, whose gas is known.
void add_outflow(const ControlVolumeModel& model, const ControlVolumeState& state, double leak_area,
                 double time, GasPoint& point) {
  const double p_a = model.ambient.pressure;
  for (const Vent& vent : model.vents)
    point.vent_mass_flow += orifice_mass_flow(
        vent.discharge_coefficient * vent_area(vent, state.triggers, time, point.pressure - p_a),
        point.pressure, point.temperature, point.gas_constant, point.cp, point.gamma, p_a);
  if (!model.fabric_velocity)
    point.fabric_mass_flow = fabric_mass_flow(leak_area, point.density, point.pressure - p_a);
  else if (point.pressure > p_a)
    point.fabric_mass_flow = leak_area * point.density * model.fabric_velocity->value(point.pressure - p_a);
}

double backflow(const ControlVolumeModel& model, const TriggerState& triggers, double time, double pressure) {
  const Ambient& ambient = model.ambient;
  if (pressure >= ambient.pressure) return 0.0;
  double area = 0.0;
  for (const Vent& vent : model.vents)
    if (vent.backflow)
      area += vent.discharge_coefficient * vent_area(vent, triggers, time, pressure - ambient.pressure);
  if (area == 0.0) return 0.0;
  const Mixture air = model.thermo.mixture(ambient.mass_fractions);
  const double cp = air.cp(ambient.temperature) / air.mass, r = air.gas_constant_sum / air.mass;
  return orifice_mass_flow(area, ambient.pressure, ambient.temperature, r, cp, cp / (cp - r), pressure);
}

/// V dp/dt [W] of 1 kg/s of a gas that enters at `temperature`.
double pressure_growth(const Mixture& gas, double temperature, const GasPoint& point) {
  return (gas.gas_constant_sum * point.temperature +
          (point.gamma - 1.0) * (gas.enthalpy(temperature) - gas.internal_energy(point.temperature))) /
         gas.mass;
}

/// The same of all inflows, the volume and the walls.
double closed_pressure_growth(const ControlVolumeModel& model, const ControlVolumeState& state,
                              double volume_rate, double time, const GasPoint& point) {
  double growth = -point.gamma * point.pressure * volume_rate - (point.gamma - 1.0) * point.heat_loss;
  for (const Inflow& inflow : model.inflows) {
    const double start = firing_time(inflow, state.triggers), flow = mass_flow(inflow, start, time);
    if (flow > 0.0)
      growth += flow * pressure_growth(model.thermo.mixture(inflow.mass_fractions),
                                       inflow.temperature.value(local_time(inflow, start, time)), point);
  }
  return growth;
}

/// Fills the flows that hold p, (G.22), in the shares that the openings have at 1e-10 p_a; false if they do
/// not carry as much there.
bool hold(const ControlVolumeModel& model, const ControlVolumeState& state, double leak_area, double growth,
          double time, GasPoint& point) {
  if (growth == 0.0) return false;
  GasPoint there = point;
  there.pressure = model.ambient.pressure * (1.0 + std::copysign(kHoldNear, growth));
  if (growth > 0.0) {
    add_outflow(model, state, leak_area, time, there);
    const double all = there.vent_mass_flow + there.fabric_mass_flow,
                 share = growth / (point.gamma * point.gas_constant * point.temperature * all);
    if (!(share <= 1.0)) return false;
    point.vent_mass_flow = share * there.vent_mass_flow;
    point.fabric_mass_flow = share * there.fabric_mass_flow;
    return true;
  }
  const double all = backflow(model, state.triggers, time, there.pressure);
  if (all == 0.0) return false;  // without backflow the model need not say what the ambient gas is
  const double raised =
      pressure_growth(model.thermo.mixture(model.ambient.mass_fractions), model.ambient.temperature, point);
  if (!(raised > 0.0)) return false;
  const double flow = -growth / raised;
  if (flow <= all) point.backflow = flow;
  return flow <= all;
}

}  // namespace

GasPoint evaluate(const ControlVolumeModel& model, const ControlVolumeState& state, double volume,
                  double leak_area, double time, double volume_rate) {
  const auto& curve = model.volume_of_overpressure;
  if (!curve && !(volume > 0.0)) throw DomainError("volume = " + to_text(volume) + " m3: must be positive");
  GasPoint point{};
  point.volume = curve ? curve->value(-model.ambient.pressure) : volume;
  point.temperature = state.temperature;
  for (const Inflow& inflow : model.inflows)
    point.inflow += mass_flow(inflow, firing_time(inflow, state.triggers), time);
  double overpressure = -model.ambient.pressure, slope = 0.0;
  const Mixture mixture = model.thermo.mixture(state.masses);
  if (mixture.mass > 0.0) {
    point.temperature = mixture.temperature(state.internal_energy, state.temperature);
    point.mass = mixture.mass;
    const double product = mixture.gas_constant_sum * point.temperature;
    if (curve) {
      const PressurePlace place = PressureVolume(*curve, model.ambient.pressure).place(product);
      if (place.beyond) throw DomainError(beyond_text(*curve));
      point.volume = place.volume;
      overpressure = place.overpressure;
      slope = place.slope;
      point.pressure = place.pressure;
    } else {
      point.pressure = product / volume;
      overpressure = point.pressure - model.ambient.pressure;
    }
    point.density = mixture.mass / point.volume;
    point.gas_constant = mixture.gas_constant_sum / mixture.mass;
    point.cp = mixture.cp(point.temperature) / mixture.mass;
    point.gamma = point.cp / (point.cp - point.gas_constant);
    point.heat_loss = model.heat_loss.conductance * (point.temperature - model.heat_loss.outside_temperature);
  }
  const double compliance = 1.0 + point.gamma * point.pressure / point.volume * slope;
  if (point.mass > 0.0 && std::abs(overpressure) <= kHoldNear * model.ambient.pressure / compliance &&
      hold(model, state, leak_area, closed_pressure_growth(model, state, volume_rate, time, point), time,
           point))
    return point;
  // On p_a the integrator lets nothing flow; the square root of what rounding leaves of p - p_a would.
  if (std::abs(overpressure) <= kNear * model.ambient.pressure) return point;
  if (point.mass > 0.0) add_outflow(model, state, leak_area, time, point);
  point.backflow = backflow(model, state.triggers, time, point.pressure);
  return point;
}

InflatorPoint inflator_point(const ControlVolumeModel& model, const ControlVolumeState& state, std::size_t i,
                             double time) {
  const Inflow& inflow = model.inflows.at(i);
  return inflator_point(model, inflow, firing_time(inflow, state.triggers), time);
}

InflatorPoint inflator_point(const ControlVolumeModel& model, std::size_t i, double time) {
  const Inflow& inflow = model.inflows.at(i);
  return inflator_point(model, inflow, inflow.start_time, time);
}

}  // namespace gas
