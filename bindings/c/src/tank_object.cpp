// SPDX-License-Identifier: Apache-2.0
#include "tank_object.hpp"

#include <algorithm>

using namespace border;

namespace {

/// Mass fractions of a gas in the numbering of the tank, which has more species.
std::vector<double> fractions_in(const gas::Thermo& all, const Gas& gas) {
  std::vector<double> fractions(all.size(), 0.0);
  for (std::size_t k = 0; k < gas.thermo.size(); ++k)
    fractions[all.index(gas.thermo.species(k).name)] = gas.mass_fractions[k];
  return fractions;
}

bool same(const gas::Species& a, const gas::Species& b) {
  return a.molar_mass == b.molar_mass && a.low == b.low && a.high == b.high && a.constant_cp == b.constant_cp;
}

/// Adds the species of a gas that are missing.
void add_species(const Gas& gas, std::vector<gas::Species>& species) {
  for (std::size_t k = 0; k < gas.thermo.size(); ++k) {
    const gas::Species& one = gas.thermo.species(k);
    const auto there =
        std::find_if(species.begin(), species.end(), [&](const auto& s) { return s.name == one.name; });
    if (there == species.end())
      species.push_back(one);
    else if (!same(*there, one))
      refuse("gas", "has another cp of " + one.name + " than the tank, allowed: the same constant_cp_at");
  }
}

gas::ControlVolumeModel model_of(const TankParts& parts) {
  std::vector<gas::Species> species;
  add_species(*parts.gas, species);
  for (const TankParts::Flow& flow : parts.inflows) add_species(*flow.gas, species);
  if (parts.outside) add_species(*parts.outside, species);
  gas::ControlVolumeModel model{gas::Thermo(species), parts.ambient, {}, parts.vents, parts.heat_loss};
  if (parts.outside) model.ambient.mass_fractions = fractions_in(model.thermo, *parts.outside);
  for (const TankParts::Flow& flow : parts.inflows)
    model.inflows.push_back(
        {fractions_in(model.thermo, *flow.gas), flow.mass_flow, flow.temperature, flow.start_time});
  for (std::size_t i = 0; i < parts.opens_at.size(); ++i) {
    if (parts.opens_at[i] == 0.0) continue;
    model.vents[i].trigger = model.triggers.sensors.size();
    model.triggers.sensors.push_back({gas::SensorKind::pressure, parts.opens_at[i]});
  }
  return model;
}

}  // namespace

Tank::Tank(TankParts given)
    : parts(std::move(given)),
      model(model_of(parts)),
      integrator(model, parts.options),
      state(gas::make_state(model, fractions_in(model.thermo, *parts.gas), parts.pressure, parts.temperature,
                            parts.volume)),
      volume(parts.volume),
      first_mass(mass()),
      first_energy(state.internal_energy) {}

double Tank::mass() const {
  double sum = 0.0;
  for (const double m : state.masses) sum += m;
  return sum;
}

void Tank::advance(double to, double new_volume) {
  const auto flux =
      integrator.advance(state, time, to, {volume, new_volume, parts.leak_area, parts.leak_area});
  time = to;
  volume = new_volume;
  started = true;
  sums.mass_in += flux.mass_in;
  sums.enthalpy_in += flux.enthalpy_in;
  sums.backflow_mass += flux.backflow_mass;
  sums.backflow_energy += flux.backflow_enthalpy;
  sums.vent_mass_out += flux.vent_mass_out;
  sums.fabric_mass_out += flux.fabric_mass_out;
  sums.enthalpy_out += flux.enthalpy_out;
  sums.work += flux.work;
  sums.heat += flux.heat;
  sums.substeps += flux.steps;
}

void Tank::change(TankParts to) {
  gas::ControlVolumeModel changed = model_of(to);
  integrator = gas::GasIntegrator(changed, to.options);
  model = std::move(changed);
  parts = std::move(to);
}

void Tank::rebuild(TankParts to) {
  Tank made(std::move(to));
  parts = std::move(made.parts);
  model = std::move(made.model);
  integrator = std::move(made.integrator);
  state = std::move(made.state);
}

gasjet_tank_balance Tank::balance() const {
  gasjet_tank_balance all = sums;
  all.mass_residual =
      mass() - first_mass - sums.mass_in - sums.backflow_mass + sums.vent_mass_out + sums.fabric_mass_out;
  all.energy_residual = state.internal_energy - first_energy - sums.enthalpy_in - sums.backflow_energy +
                        sums.enthalpy_out + sums.work + sums.heat;
  return all;
}
