// SPDX-License-Identifier: Apache-2.0
// The gas that the unknowns of a FlowBalance stand for, and the state at the end of a step.
#include <algorithm>

#include "flow_balance.hpp"
#include "gas/error.hpp"
#include "pressure_volume.hpp"
#include "require.hpp"

namespace gas {
namespace {

// A species that runs out leaves a remainder of round-off, of either sign, relative to what passed through.
constexpr double kMassRoundOff = 1e-13;

}  // namespace

/// Fills masses_, at time t, and returns the internal energy there, of a volume that follows p with the work
/// since t0. (G.9), (G.10)
double FlowBalance::collect(const Vector& y, double t) {
  double energy = start_->internal_energy;
  std::ranges::copy(start_->masses, masses_.begin());
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const auto delivered = segments_[i].delivered(t - segment_begin_);
    energy += delivered_[i].enthalpy + delivered.enthalpy;
    const double mass = delivered_[i].mass + delivered.mass;
    for (std::size_t k = 0; k < masses_.size(); ++k) masses_[k] += model_.inflows[i].mass_fractions[k] * mass;
  }
  point_.depleted.reset();
  for (std::size_t k = 0; k < masses_.size(); ++k) {
    for (std::size_t j = 0; j < backflows(); ++j)
      masses_[k] += model_.ambient.mass_fractions[k] * y[back_slot(j)];
    const double available = masses_[k];
    masses_[k] = std::max(0.0, available - y[k]);
    if (!(y[k] <= available * (1.0 + kMassRoundOff))) point_.depleted = k;
  }
  point_.valid = !point_.depleted;
  return energy + energy_change(y);
}

/// Of the gas in mixture_ with what collect() returns.
std::optional<double> FlowBalance::temperature_of(double energy) const {
  const auto& curve = model_.volume_of_overpressure;
  return curve ? find_temperature(mixture_, *curve, ambient_pressure(), energy + work_begin_,
                                  point_.temperature)
               : mixture_.find_temperature(energy, point_.temperature);
}

/// The point of the gas in mixture_, but for its flows.
void FlowBalance::place_gas(double energy, double temperature) {
  const double cp = mixture_.cp(temperature), r = mixture_.gas_constant_sum;
  double capacity = cp - r;
  point_.gamma = cp / capacity;
  point_.temperature = temperature;
  if (const auto& curve = model_.volume_of_overpressure) {
    const PressurePlace place = pressure_place(*curve, ambient_pressure(), r * temperature);
    capacity = heat_capacity(place, capacity, r);
    point_.volume = place.volume;
    point_.pressure = place.pressure;
    point_.compliance = 1.0 + point_.gamma * place.pressure * place.slope / place.volume;
    point_.work = place.work;
    point_.beyond = place.beyond;
    energy -= place.work - work_begin_;
  } else {
    point_.pressure = r * temperature / point_.volume;
  }
  point_.thermal_energy = capacity * temperature;
  point_.specific_enthalpy = (energy + r * temperature) / mixture_.mass;
}

/// Temperature and pressure, (G.8); no gas has neither energy nor pressure.
void FlowBalance::locate(const Vector& y, double t) {
  const double energy = collect(y, t);
  model_.thermo.mixture(masses_, mixture_);
  point_.mass = mixture_.mass;
  point_.volume =
      model_.volume_of_overpressure ? model_.volume_of_overpressure->value(-ambient_pressure()) : volume(t);
  point_.pressure = point_.gamma = point_.thermal_energy = point_.specific_enthalpy = 0.0;
  point_.compliance = 1.0;
  point_.heat = point_.work = 0.0;
  point_.beyond = false;
  if (!point_.valid || mixture_.mass == 0.0) return;
  const auto temperature = temperature_of(energy);
  point_.valid = temperature.has_value();
  if (!temperature) return;
  place_gas(energy, *temperature);
  if (point_.beyond) point_.valid = false;
  point_.heat = model_.heat_loss.conductance * (*temperature - model_.heat_loss.outside_temperature);
}

double FlowBalance::pressure(const Vector& y, double t) {
  segment_begin_ = t;
  locate(y, t);
  return point_.pressure;
}

/// Work since t0 of the gas in mixture_, with what collect() returns.
double FlowBalance::settled_work(double energy) {
  const auto temperature = temperature_of(energy);
  if (!temperature)
    throw DomainError("the gas leaves its temperature range, " + to_text(mixture_.minimum_temperature) +
                      " to " + to_text(mixture_.maximum_temperature) + " K");
  place_gas(energy, *temperature);
  if (point_.beyond) throw DomainError(beyond_text(*model_.volume_of_overpressure));
  return point_.work - work_begin_;
}

void FlowBalance::finish(Vector& y, ControlVolumeState& state) {
  double internal_energy = collect(y, segment_begin_);
  model_.thermo.mixture(masses_, mixture_);
  if (model_.volume_of_overpressure && mixture_.mass > 0.0) {
    y[work_slot()] = settled_work(internal_energy);
    internal_energy -= y[work_slot()];
  }
  if (mixture_.mass > 0.0) state.temperature = mixture_.temperature(internal_energy, point_.temperature);
  state.internal_energy = internal_energy;
  std::ranges::copy(masses_, state.masses.begin());
}

}  // namespace gas
