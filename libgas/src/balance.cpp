// SPDX-License-Identifier: Apache-2.0
#include "balance.hpp"

#include <algorithm>

namespace gas {
namespace {

/// V dp/dt [W] in a rigid volume for 1 kg/s of `mixture` that enters `gas` at `temperature` [K].
double growth_per_flow(const Mixture& mixture, double temperature, const UniformGas& gas) {
  return (mixture.gas_constant_sum * gas.temperature +
          (gas.gamma - 1.0) * (mixture.enthalpy(temperature) - mixture.internal_energy(gas.temperature))) /
         mixture.mass;
}

}  // namespace

Balance::Balance(const Boundary& boundary) : boundary_(boundary), masses_(boundary.slots().species) {}

bool Balance::locate(std::span<const double> amount, double t) {
  time_ = t;
  std::ranges::copy(amount.first(masses_.size()), masses_.begin());
  const ControlVolumeModel& model = boundary_.model();
  model.thermo.mixture(masses_, mixture_);
  return gas::locate(model, mixture_, amount.back(), boundary_.path().volume(t), gas_);
}

void Balance::fill_rates(Vector& dydt) {
  const Slots& s = boundary_.slots();
  const Upstream<double> gas = gas_.upstream();
  std::ranges::fill(dydt, 0.0);
  flow_ = 0.0;
  if (gas_.overpressure < 0.0)
    for (std::size_t j = 0; j < s.backflows; ++j)
      flow_ -= dydt[s.back(j)] = boundary_.back(j, gas, time_);  // mdot_back, (G.6) reversed
  if (gas_.mass == 0.0) return;
  if (gas_.overpressure > 0.0) {
    for (std::size_t j = 0; j < s.streams(); ++j) {
      flow_ += dydt[s.mass(j)] = boundary_.out(j, gas, time_);  // mdot, (G.6), (G.7) or (G.12)
      dydt[s.enthalpy(j)] = dydt[s.mass(j)] * gas_.enthalpy;    // mdot h(T)
    }
    for (std::size_t k = 0; k < s.species; ++k) dydt[s.out(k)] = fraction(k) * flow_;  // Y_k sum mdot
  }
  dydt[s.work()] = gas_.pressure * boundary_.path().rate(time_);    // p dV/dt
  dydt[s.heat()] = heat_flow(boundary_.model(), gas_.temperature);  // Q, (G.11)
}

double Balance::closed_growth() const {
  if (gas_.mass == 0.0) return 0.0;
  const Inflows& inflows = boundary_.inflows();
  double growth = -gas_.gamma * gas_.pressure * boundary_.path().rate(time_) -
                  (gas_.gamma - 1.0) * heat_flow(boundary_.model(), gas_.temperature);
  for (std::size_t i = 0; i < inflows.size(); ++i) {
    if (inflows[i].is_idle()) continue;
    const auto [mass_flow, temperature] = inflows[i].flow(time_);
    growth += mass_flow * growth_per_flow(inflows[i].gas(), temperature, gas_);
  }
  return growth / gas_.compliance();
}

double Balance::open_growth(double flow) const {
  if (flow == 0.0) return 0.0;
  const AmbientGas& air = boundary_.ambient();
  const double growth = flow > 0.0 ? gas_.gamma * gas_.gas_constant * gas_.temperature
                                   : growth_per_flow(air.mixture, air.temperature, gas_);
  return -flow * growth / gas_.compliance();
}

double Balance::pressure_rate() const {
  if (gas_.mass == 0.0) return 0.0;
  return (closed_growth() + open_growth(flow_)) / gas_.volume;
}

}  // namespace gas
