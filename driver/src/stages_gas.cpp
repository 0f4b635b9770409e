// SPDX-License-Identifier: Apache-2.0
// S2 gas point, S10 gas.
#include "stages.hpp"

namespace driver {

Enclosure enclosure(const Scene& scene, const State& state) {
  if (!scene.bag) return {scene.gas ? scene.gas->rigid_volume.value_or(0.0) : 0.0, 0.0};
  const auto& surface = state.bag->surface;
  switch (scene.bag->leak_law) {
    case LeakLaw::printed:
      return {surface.volume, surface.porosity_squared_area};
    case LeakLaw::screen:
      return {surface.volume, surface.porosity_area};
    case LeakLaw::none:
      break;
  }
  return {surface.volume, 0.0};
}

void gas_point(const Scene& scene, State& state) {
  StageTimer timer(state, Stage::gas_point);
  state.level.flows = state.flows;
  if (!scene.gas || !scene.has_volume()) return;
  const Enclosure now = enclosure(scene, state);
  state.gas_point = gas::evaluate(scene.gas->model, state.gas, now.volume, now.leak_area, state.time);
  state.level.internal_energy = state.gas.internal_energy;
  state.level.volume = now.volume;
  if (state.bag) state.level.skin_area = state.bag->surface.area;
}

void gas_ode(const Scene& scene, State& state, const Enclosure& before) {
  StageTimer timer(state, Stage::gas);
  if (!scene.gas || !scene.has_volume()) return;
  const Enclosure after = enclosure(scene, state);
  const double next = state.time + state.step.after;
  const auto fluxes = state.gas_integrator->advance(
      state.gas, state.time, next, {before.volume, after.volume, before.leak_area, after.leak_area});
  Flows& flows = state.flows;
  flows.mass_in += fluxes.mass_in;
  flows.enthalpy_in += fluxes.enthalpy_in;
  flows.vent_mass_out += fluxes.vent_mass_out;
  flows.fabric_mass_out += fluxes.fabric_mass_out;
  flows.enthalpy_out += fluxes.enthalpy_out;
  if (state.bag && !scene.jets.empty() && scene.jets.front().work == JetWork::from_gas)
    state.gas.internal_energy -= state.bag->advance.work.jet;
}

}  // namespace driver
