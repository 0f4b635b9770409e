// SPDX-License-Identifier: Apache-2.0
#include "step/ambient_energies.hpp"

#include <algorithm>
#include <numeric>
#include <span>

namespace driver {
namespace {

double product(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

std::vector<double> species_at_ambient(const Scene& scene) {
  const gas::Thermo& thermo = scene.gas->model.thermo;
  const double temperature =
      std::clamp(scene.ambient.temperature, thermo.minimum_temperature(), thermo.maximum_temperature());
  std::vector<double> energy;
  for (std::size_t k = 0; k < thermo.size(); ++k) energy.push_back(thermo.internal_energy(k, temperature));
  return energy;
}

// What left is what was there and came in, less what is there.
AmbientEnergies ambient_energies(const Scene& scene, const State& state) {
  const gas::ControlVolumeModel& model = scene.gas->model;
  const std::vector<double>& energy = state.start.ambient_energy;
  AmbientEnergies sum;
  sum.held = product(state.gas.masses, energy);
  for (std::size_t i = 0; i < model.inflows.size(); ++i)
    sum.inflow += state.streams.inflows[i].mass * product(model.inflows[i].mass_fractions, energy);
  if (const double mass = state.flows.backflow_mass; mass > 0.0)
    sum.backflow = mass * product(model.ambient.mass_fractions, energy);
  sum.outflow = product(state.start.masses, energy) + sum.inflow + sum.backflow - sum.held;
  return sum;
}

}  // namespace driver
