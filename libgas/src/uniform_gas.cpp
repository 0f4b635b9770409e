// SPDX-License-Identifier: Apache-2.0
#include "uniform_gas.hpp"

namespace gas {

GasLocator::GasLocator(const ControlVolumeModel& model) : model_(model) {
  if (model.volume_of_overpressure)
    volume_by_pressure_.emplace(*model.volume_of_overpressure, model.ambient.pressure);
}

std::optional<UniformGas> GasLocator::locate(const Mixture& mixture, double energy, double volume,
                                             double guess) const {
  UniformGas gas{};
  gas.overpressure = -model_.ambient.pressure;
  gas.temperature = guess;
  gas.volume = volume_by_pressure_ ? volume_by_pressure_->smallest() : volume;
  if (mixture.mass == 0.0) return gas;
  const auto temperature = volume_by_pressure_ ? volume_by_pressure_->find_temperature(mixture, energy, guess)
                                               : mixture.find_temperature(energy, guess);
  if (!temperature) return {};
  const double t = *temperature, r = mixture.gas_constant_sum, cp = mixture.cp(t);
  gas.mass = mixture.mass;
  gas.temperature = t;
  gas.gas_constant = r / mixture.mass;
  gas.cp = cp / mixture.mass;
  gas.gamma = cp / (cp - r);
  gas.capacity = cp - r;
  if (volume_by_pressure_) {
    const PressurePlace place = volume_by_pressure_->place(r * t);
    gas.pressure = place.pressure;
    gas.overpressure = place.overpressure;
    gas.volume = place.volume;
    gas.volume_slope = place.slope;
    gas.work = place.work;
    gas.beyond = place.beyond;
    gas.capacity = heat_capacity(place, cp - r, r);
  } else {
    gas.pressure = r * t / volume;
    gas.overpressure = gas.pressure - model_.ambient.pressure;
  }
  gas.enthalpy = (energy - gas.work + r * t) / mixture.mass;
  return gas;
}

double GasLocator::work_at(const Mixture& mixture, double temperature) const {
  return volume_by_pressure_ ? volume_by_pressure_->place(mixture.gas_constant_sum * temperature).work : 0.0;
}

double GasLocator::stored_work(const ControlVolumeState& state) const {
  if (!volume_by_pressure_) return 0.0;
  const Mixture mixture = model_.thermo.mixture(state.masses);
  if (mixture.mass == 0.0) return 0.0;
  return work_at(mixture, mixture.temperature(state.internal_energy, state.temperature));
}

}  // namespace gas
