// SPDX-License-Identifier: Apache-2.0
#include "balance.hpp"

#include <algorithm>

namespace gas {

Balance::Balance(const Boundary& boundary)
    : boundary_(boundary), locator_(boundary.model()), masses_(boundary.slots().species) {}

void Balance::begin_step(const ControlVolumeState& state) {
  gas_.temperature = state.temperature;
  work_begin_ = locator_.stored_work(state);
}

bool Balance::locate(std::span<const double> gas, double t) {
  time_ = t;
  std::ranges::copy(gas.first(masses_.size()), masses_.begin());
  boundary_.model().thermo.mixture(masses_, mixture_);
  const auto found =
      locator_.locate(mixture_, gas.back() + work_begin_, boundary_.path().volume(t), gas_.temperature);
  if (found) gas_ = *found;
  return found.has_value();
}

void Balance::fill_rates(Vector& dydt) {
  const Slots& s = boundary_.slots();
  std::ranges::fill(dydt, 0.0);
  outflow_ = backflow_ = 0.0;
  if (gas_.overpressure < 0.0 && boundary_.has_backflow())
    for (std::size_t j = 0; j < s.backflows; ++j)
      backflow_ += dydt[s.back(j)] = boundary_.back(j, gas_, time_);  // mdot_back, (G.6) the other way
  if (gas_.mass == 0.0) return;
  if (gas_.overpressure > 0.0) {
    for (std::size_t j = 0; j < s.vents; ++j)
      dydt[s.mass(j)] = boundary_.out(j, gas_, time_);  // mdot_vent, (G.6)
    for (std::size_t i = 0; i < s.fabrics; ++i)
      dydt[s.mass(s.fabric(i))] = boundary_.out(s.fabric(i), gas_, time_);  // mdot_fabric, (G.7) or (G.12)
    for (std::size_t j = 0; j < s.streams(); ++j) {
      outflow_ += dydt[s.mass(j)];
      dydt[s.enthalpy(j)] = dydt[s.mass(j)] * gas_.enthalpy;  // mdot h(T)
    }
    for (std::size_t k = 0; k < s.species; ++k) dydt[s.out(k)] = fraction(k) * outflow_;  // Y_k sum mdot
  }
  dydt[s.work()] = gas_.pressure * boundary_.path().rate(time_);  // p dV/dt
  dydt[s.heat()] = heat_flow(boundary_.model(), gas_);            // Q, (G.11)
}

double Balance::pressure_rate() const {
  if (gas_.mass == 0.0) return 0.0;
  double growth = -gas_.gamma * gas_.gas_constant * gas_.temperature * outflow_;
  if (backflow_ > 0.0) {
    const AmbientGas& air = boundary_.ambient();
    growth += backflow_ * growth_per_flow(air.mixture, air.temperature, gas_);
  }
  return (closed_growth() + growth / gas_.compliance()) / gas_.volume;
}

}  // namespace gas
