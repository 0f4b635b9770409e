// SPDX-License-Identifier: Apache-2.0
// S2 gas point, S10 gas.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "engine/stages.hpp"
#include "step/ambient_energies.hpp"

namespace driver {

Enclosure enclosure(const Scene& scene, const State& state) {
  if (!scene.bag) {
    if (!scene.gas) return {};
    const GasPart& gas = *scene.gas;
    return {gas.tank_volume ? gas.tank_volume->at(state.time) : gas.rigid_volume.value_or(0.0),
            gas.tank_leak_area};
  }
  const auto& surface = state.bag->surface;
  switch (scene.bag->leak_law) {
    case LeakLaw::printed:
      return {surface.volume, surface.porosity_squared_area};
    case LeakLaw::screen:
    case LeakLaw::table:
      return {surface.volume, surface.porosity_area};
    case LeakLaw::none:
      break;
  }
  return {surface.volume, 0.0};
}

namespace {

// From when on, since its opening, a vent has an area [s].
double dead_time(const gas::Vent& vent) {
  if (!vent.area_of_time) return 0.0;
  const auto knots = vent.area_of_time->knots();
  const auto first = std::ranges::find_if(knots, [](const auto& knot) { return knot.value > 0.0; });
  if (first == knots.begin()) return 0.0;
  return first == knots.end() ? std::numeric_limits<double>::infinity()
                              : std::max(0.0, std::prev(first)->time);
}

// When a vent whose trigger is `node` first has an area, as far as level n tells [s]; NaN: not yet.
double opening(const Scene& scene, const State& state, const gas::Vent& vent, const gas::NodeState& node) {
  constexpr double not_yet = std::numeric_limits<double>::quiet_NaN();
  if (vent.area_of_overpressure) {
    const double excess = state.gas_point.pressure - scene.ambient.pressure;
    return node.on && vent.area_of_overpressure->value(excess) > 0.0 ? state.time : not_yet;
  }
  const double dead = dead_time(vent), start = (dead == 0.0 ? node.first_on : node.since) + dead;
  return start <= state.time ? start : not_yet;
}

// The trigger may have gone off again within the step: then what has passed through the vent tells.
void note_opening(const Scene& scene, State& state, std::size_t j) {
  double& opened = state.gas_events.opened[j];
  if (!std::isnan(opened)) return;
  const gas::Vent& vent = scene.gas->model.vents[j];
  const gas::NodeState always{.on = true, .since = 0.0, .first_on = 0.0, .held_since = 0.0};
  opened = opening(scene, state, vent, vent.trigger ? state.gas.triggers[*vent.trigger] : always);
  const bool passed = state.streams.outflows[j].mass > 0.0 || state.streams.backflows[j].mass > 0.0;
  if (std::isnan(opened) && passed) opened = state.time;
}

}  // namespace

void gas_point(const Scene& scene, State& state) {
  StageTimer timer(state, Stage::gas_point);
  state.level.flows = state.flows;
  if (state.bag) state.level.skin_area = state.bag->surface.area;
  if (!scene.gas || !scene.has_volume()) return;
  const Enclosure now = enclosure(scene, state);
  state.gas_point = gas::evaluate(scene.gas->model, state.gas, now.volume, now.leak_area, state.time);
  state.level.internal_energy = state.gas.internal_energy + state.jet_work.ahead();
  state.level.volume = state.gas_point.volume;
  state.level.ambient = state.streams.ambient;
  for (std::size_t j = 0; j < state.gas_events.opened.size(); ++j) note_opening(scene, state, j);
  if (!scene.output.streams) return;
  state.level.masses = state.gas.masses;  // of the sizes that they had in make_state
  state.level.streams = state.streams;
}

namespace {

void add(std::span<const gas::StreamFlux> fluxes, std::vector<gas::StreamFlux>& sums) {
  for (std::size_t i = 0; i < fluxes.size(); ++i) {
    sums[i].mass += fluxes[i].mass;
    sums[i].enthalpy += fluxes[i].enthalpy;
  }
}

// All outflows of a step have one composition.
void book_ambient(const Scene& scene, const gas::StepFluxes& fluxes, State& state) {
  Streams& streams = state.streams;
  streams.ambient = ambient_energies(scene, state);
  const double mass = fluxes.vent_mass_out + fluxes.fabric_mass_out;
  if (!(mass > 0.0)) return;
  const double left = streams.ambient.outflow -
                      std::accumulate(streams.outflow_ambient.begin(), streams.outflow_ambient.end(), 0.0);
  for (std::size_t i = 0; i < streams.outflow_ambient.size(); ++i)
    streams.outflow_ambient[i] += fluxes.outflows[i].mass / mass * left;
}

void book(const Scene& scene, const gas::StepFluxes& fluxes, State& state) {
  Flows& flows = state.flows;
  flows.mass_in += fluxes.mass_in;
  flows.enthalpy_in += fluxes.enthalpy_in;
  flows.vent_mass_out += fluxes.vent_mass_out;
  flows.fabric_mass_out += fluxes.fabric_mass_out;
  flows.enthalpy_out += fluxes.enthalpy_out;
  flows.backflow_mass += fluxes.backflow_mass;
  flows.backflow_enthalpy += fluxes.backflow_enthalpy;
  flows.heat_loss += fluxes.heat;
  flows.gas_work += fluxes.work;
  flows.gas_substeps += fluxes.steps;
  flows.gas_evaluations += fluxes.evaluations;
  gas::StepMoments& last = state.gas_events.last;
  if (!std::isnan(fluxes.moments.sonic_switch)) last.sonic_switch = fluxes.moments.sonic_switch;
  if (!std::isnan(fluxes.moments.equalisation)) last.equalisation = fluxes.moments.equalisation;
  add(fluxes.inflows, state.streams.inflows);
  add(fluxes.outflows, state.streams.outflows);
  add(fluxes.backflows, state.streams.backflows);
  book_ambient(scene, fluxes, state);
}

/// A tank that moves along its path: steps end at the ends of the path's pieces.
void advance_tank(const Scene& scene, double leak_area, double next, State& state) {
  const TankVolume& volume = *scene.gas->tank_volume;
  for (double t = state.time; t < next;) {
    const double end = std::min(volume.piece_end(t), next);
    book(scene, state.gas_integrator->advance(state.gas, t, end, volume.piece(t, end, leak_area)), state);
    t = end;
  }
}

// A bag that is empty: no gas fits into what is left.
void require_inside(double volume) {
  if (!(volume > 0.0 && std::isfinite(volume)))
    throw std::domain_error(
        fmt::format("volume = {:.3g} m3: must be positive and finite. The skin has collapsed or turned "
                    "inside out, perhaps because more gas flows out than in: check areas of vents, porosity, "
                    "times of mass_flow, end_time, and their units",
                    volume));
}

}  // namespace

void gas_ode(const Scene& scene, State& state, const Enclosure& before) {
  StageTimer timer(state, Stage::gas);
  if (!scene.gas || !scene.has_volume()) return;
  const double next = state.time + state.step.after;
  for (const std::size_t sensor : scene.gas->contact_sensors)
    gas::set_input(scene.gas->model.triggers, sensor, state.contact.area > 0.0, state.gas.triggers);
  if (scene.gas->tank_volume) return advance_tank(scene, before.leak_area, next, state);
  const Enclosure after = enclosure(scene, state);
  if (scene.bag) require_inside(after.volume);
  book(scene,
       state.gas_integrator->advance(state.gas, state.time, next,
                                     {before.volume, after.volume, before.leak_area, after.leak_area}),
       state);
  if (state.bag && scene.jet_work == JetWork::from_gas)
    state.jet_work.take(state.bag->advance.work.jet, state.step.before, state.step.after, state.gas);
}

}  // namespace driver
