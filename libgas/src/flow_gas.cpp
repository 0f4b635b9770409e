// SPDX-License-Identifier: Apache-2.0
// The gas that the unknowns of a FlowBalance stand for, and the state at the end of a step.
#include <algorithm>

#include "flow_balance.hpp"
#include "gas/error.hpp"
#include "pressure_volume.hpp"
#include "require.hpp"

namespace gas {
/// Of the gas in mixture_ with `energy` U, of a volume that follows p with the work since t0.
std::optional<double> FlowBalance::temperature_of(double energy) const {
  return volume_by_pressure_
             ? volume_by_pressure_->find_temperature(mixture_, energy + work_begin_, point_.temperature)
             : mixture_.find_temperature(energy, point_.temperature);
}

/// The point of the gas in mixture_, but for its flows.
void FlowBalance::place_gas(double energy, double temperature) {
  const double cp = mixture_.cp(temperature), r = mixture_.gas_constant_sum;
  double capacity = cp - r;
  point_.gamma = cp / capacity;
  point_.temperature = temperature;
  if (volume_by_pressure_) {
    const PressurePlace place = volume_by_pressure_->place(r * temperature);
    capacity = heat_capacity(place, capacity, r);
    work_share_ = work_share(place);
    point_.volume = place.volume;
    point_.pressure = place.pressure;
    point_.overpressure = place.overpressure;
    point_.compliance = 1.0 + point_.gamma * place.pressure * place.slope / place.volume;
    point_.work = place.work;
    point_.beyond = place.beyond;
    energy -= place.work - work_begin_;
  } else {
    point_.pressure = r * temperature / point_.volume;
    point_.overpressure = point_.pressure - ambient_pressure();
  }
  point_.thermal_energy = capacity * temperature;
  point_.specific_enthalpy = (energy + r * temperature) / mixture_.mass;
}

/// Temperature and pressure of masses_ and energy_, (G.8); no gas has neither energy nor pressure.
void FlowBalance::find_point(double t) {
  model_.thermo.mixture(masses_, mixture_);
  point_.mass = mixture_.mass;
  point_.volume =
      model_.volume_of_overpressure ? model_.volume_of_overpressure->value(-ambient_pressure()) : volume(t);
  point_.pressure = point_.gamma = point_.thermal_energy = point_.specific_enthalpy = 0.0;
  point_.overpressure = -ambient_pressure();
  point_.compliance = 1.0;
  point_.heat = point_.work = 0.0;
  point_.beyond = false;
  point_.valid = !point_.depleted;
  if (!point_.valid || mixture_.mass == 0.0) return;
  const auto temperature = temperature_of(energy_);
  point_.valid = temperature.has_value();
  if (!temperature) return;
  place_gas(energy_, *temperature);
  point_.heat = model_.heat_loss.conductance * (*temperature - model_.heat_loss.outside_temperature);
}

void FlowBalance::move_pressure(const Point& at, double change) {
  point_.pressure = at.pressure + change;
  point_.overpressure = at.overpressure + change;
  if (!volume_by_pressure_) return;
  point_.volume = at.volume * (1.0 + (at.compliance - 1.0) / at.gamma * change / at.pressure);
  point_.compliance = at.compliance;
}

double FlowBalance::pressure_slope(const Point& at, std::size_t part) const {
  const double product = part < masses_.size() ? model_.thermo.gas_constant(part) * at.temperature
                                               : at.pressure * at.volume / at.thermal_energy;
  return product / (at.volume * (1.0 + (at.compliance - 1.0) / at.gamma));
}

/// Work since t0 of the gas in mixture_, its energy that of supply().
double FlowBalance::settled_work() {
  const auto temperature = temperature_of(energy_);
  if (!temperature)
    throw DomainError("the gas leaves its temperature range, " + to_text(mixture_.minimum_temperature) +
                      " to " + to_text(mixture_.maximum_temperature) + " K");
  place_gas(energy_, *temperature);
  if (point_.beyond) throw DomainError(beyond_text(*model_.volume_of_overpressure));
  return point_.work - work_begin_;
}

void FlowBalance::finish(ControlVolumeState& state) {
  supply(segment_begin_);
  model_.thermo.mixture(masses_, mixture_);
  if (model_.volume_of_overpressure && mixture_.mass > 0.0) {
    const double work = settled_work();
    totals_[work_slot()] = work;
    energy_ -= work;
  }
  if (mixture_.mass > 0.0) state.temperature = mixture_.temperature(energy_, point_.temperature);
  state.internal_energy = energy_;
  std::ranges::copy(masses_, state.masses.begin());
}

}  // namespace gas
