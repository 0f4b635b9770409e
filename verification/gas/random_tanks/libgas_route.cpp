// SPDX-License-Identifier: Apache-2.0
#include "libgas_route.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "gas/error.hpp"

namespace random_tanks {
namespace {

gas::Curve curve_of(const Table& table, gas::Outside outside) {
  std::vector<gas::Curve::Knot> knots;
  for (std::size_t i = 0; i < table.x.size(); ++i) knots.push_back({table.x[i], table.y[i]});
  return {knots, outside};
}

std::optional<gas::Curve> optional_curve(const Table& table) {
  if (table.empty()) return {};
  return curve_of(table, gas::Outside::held);
}

gas::Thermo thermo_of(const Tank& tank) {
  std::vector<gas::Species> species;
  for (const Gas& g : tank.gases)
    species.push_back(g.cp == 0.0 ? gas::nasa7_species(g.name)
                                  : gas::constant_cp_species(g.name, g.gas_constant, g.cp));
  return gas::Thermo(species);
}

gas::TriggerModel triggers_of(const Tank& tank) {
  gas::TriggerModel model;
  for (const SensorPlan& s : tank.sensors) {
    const gas::SensorKind kind = s.kind == Watch::time     ? gas::SensorKind::time
                                 : s.kind == Watch::signal ? gas::SensorKind::signal
                                                           : gas::SensorKind::pressure;
    model.sensors.push_back({kind, s.threshold, s.reset, optional_curve(s.signal)});
  }
  for (const GatePlan& g : tank.gates) {
    const gas::Logic logic = g.logic == Join::all   ? gas::Logic::all
                             : g.logic == Join::any ? gas::Logic::any
                                                    : gas::Logic::negated;
    model.gates.push_back({logic, g.inputs, g.delay, g.latch});
  }
  return model;
}

/// Adds terms, and their magnitudes.
struct Account {
  double sum = 0.0, size = 0.0;
  void add(double term) {
    sum += term;
    size += std::abs(term);
  }
  double share() const { return size > 0.0 ? std::abs(sum) / size : 0.0; }
};

double mass_of(const gas::ControlVolumeState& state) {
  return std::accumulate(state.masses.begin(), state.masses.end(), 0.0);
}

/// Largest residual of what one call says against what it did to the state: mass and energy, and each species
/// where nothing leaves.
double residual(const gas::ControlVolumeModel& model, const gas::ControlVolumeState& before,
                const gas::ControlVolumeState& after, const gas::StepFluxes& f) {
  Account mass, energy;
  for (const double m :
       {mass_of(before), -mass_of(after), f.mass_in, f.backflow_mass, -f.vent_mass_out, -f.fabric_mass_out})
    mass.add(m);
  for (const double e : {before.internal_energy, -after.internal_energy, f.enthalpy_in, f.backflow_enthalpy,
                         -f.enthalpy_out, -f.work, -f.heat})
    energy.add(e);
  double worst = std::max(mass.share(), energy.share());
  if (f.vent_mass_out > 0.0 || f.fabric_mass_out > 0.0) return worst;
  for (std::size_t k = 0; k < before.masses.size(); ++k) {
    Account species;
    species.add(before.masses[k]);
    species.add(-after.masses[k]);
    for (std::size_t i = 0; i < f.inflows.size(); ++i)
      species.add(model.inflows[i].mass_fractions[k] * f.inflows[i].mass);
    species.add(f.backflow_mass == 0.0 ? 0.0 : model.ambient.mass_fractions[k] * f.backflow_mass);
    worst = std::max(worst, species.share());
  }
  return worst;
}

Sample sample_of(const gas::ControlVolumeModel& model, const gas::ControlVolumeState& state, double volume,
                 double leak_area, double time) {
  const gas::GasPoint point = gas::evaluate(model, state, volume, leak_area, time);
  return {time,        point.pressure, point.temperature, point.mass, point.pressure - model.ambient.pressure,
          state.masses};
}

}  // namespace

gas::ControlVolumeModel model_of(const Tank& tank) {
  gas::ControlVolumeModel model{
      thermo_of(tank), {tank.ambient_pressure, tank.ambient_temperature, tank.ambient}, {}, {}};
  for (const Pulse& p : tank.pulses)
    model.inflows.push_back({p.fractions, curve_of(p.mass_flow, gas::Outside::zero),
                             curve_of(p.temperature, gas::Outside::held), p.start, p.node});
  for (const Hole& h : tank.holes)
    model.vents.push_back({h.discharge_coefficient, h.area, optional_curve(h.area_of_time),
                           optional_curve(h.area_of_overpressure), h.backflow, h.node});
  model.heat_loss = {tank.conductance, tank.outside_temperature};
  model.fabrics = {{1.0, optional_curve(tank.fabric_velocity)}};
  model.volume_of_overpressure = optional_curve(tank.volume_of_overpressure);
  model.triggers = triggers_of(tank);
  return model;
}

Computed libgas_route(const Tank& tank) {
  const gas::ControlVolumeModel model = model_of(tank);
  gas::GasIntegrator integrator(model, {.relative_tolerance = tank.tolerance});
  gas::ControlVolumeState state =
      gas::make_state(model, tank.start, tank.pressure, tank.temperature, tank.volumes.front());
  Computed result;
  try {
    result.samples.push_back(sample_of(model, state, tank.volumes[0], tank.leak_areas[0], tank.times[0]));
    for (std::size_t i = 0; i + 1 < tank.times.size(); ++i) {
      const gas::ControlVolumeState before = state;
      const gas::StepFluxes f = integrator.advance(
          state, tank.times[i], tank.times[i + 1],
          {tank.volumes[i], tank.volumes[i + 1], tank.leak_areas[i], tank.leak_areas[i + 1], tank.bulges[i]});
      result.balance = std::max(result.balance, residual(model, before, state, f));
      result.samples.push_back(
          sample_of(model, state, tank.volumes[i + 1], tank.leak_areas[i + 1], tank.times[i + 1]));
    }
  } catch (const gas::DomainError& error) {
    result.refusal = error.what();
    result.refused_at = error.time;
  }
  return result;
}

}  // namespace random_tanks
