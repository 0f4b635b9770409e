// SPDX-License-Identifier: Apache-2.0
// Rates of the pressure that the integrator's events need, the gas's own relaxation rate, heat of the first gas.
#include <algorithm>
#include <cmath>

#include "flow_balance.hpp"
#include "gas/orifice.hpp"

namespace gas {
namespace {

/// V dp/dt of 1 kg/s of `gas` at `temperature`, entering gas that has point's temperature and gamma.
double pressure_growth(const Mixture& gas, double temperature, const FlowBalance::Point& point) {
  return (gas.gas_constant_sum * point.temperature +
          (point.gamma - 1.0) * (gas.enthalpy(temperature) - gas.internal_energy(point.temperature))) /
         gas.mass;
}

/// `to` plus factor times the amount `from`.
void add(double factor, const Mixture& from, Mixture& to) {
  to.constant_cp = from.constant_cp;
  to.minimum_temperature = from.minimum_temperature;
  to.maximum_temperature = from.maximum_temperature;
  to.gas_constant_sum += factor * from.gas_constant_sum;
  for (std::size_t j = 0; j < to.low.size(); ++j) {
    to.low[j] += factor * from.low[j];
    to.high[j] += factor * from.high[j];
  }
}

}  // namespace

/// (G.11) while an evacuated volume begins to fill: without a heat capacity, T is where inflow and walls
/// balance, sum mdot_i (h_i - u_i(T)) = h A (T - T_ext), which is the equation of a mixture with h A added to
/// its cp.
double FlowBalance::heat_of_first_gas(double t) const {
  const HeatLoss& loss = model_.heat_loss;
  if (loss.conductance == 0.0) return 0.0;
  Mixture sum;
  double energy = loss.conductance * loss.outside_temperature, flow = 0.0;
  for (const InflowSegment& segment : segments_) {
    const auto [mass_flow, temperature] = segment.flow(t - segment_begin_);
    if (!(mass_flow > 0.0)) continue;
    energy += mass_flow * segment.gas().enthalpy(temperature);
    add(mass_flow, segment.gas(), sum);
    flow += mass_flow;
  }
  if (flow == 0.0) return 0.0;
  sum.low[0] += loss.conductance;
  sum.high[0] += loss.conductance;
  const auto temperature = sum.find_temperature(energy, loss.outside_temperature);
  return temperature ? loss.conductance * (*temperature - loss.outside_temperature) : 0.0;
}

double FlowBalance::closed_pressure_growth(double t) const {
  double growth = -point_.gamma * point_.pressure * volume_rate_ - (point_.gamma - 1.0) * point_.heat;
  for (const InflowSegment& segment : segments_) {
    const auto [mass_flow, temperature] = segment.flow(t - segment_begin_);
    if (mass_flow > 0.0) growth += mass_flow * pressure_growth(segment.gas(), temperature, point_);
  }
  return growth;
}

double FlowBalance::pressure_rate(double t) const {
  if (point_.mass == 0.0) return 0.0;
  const double gas_constant = mixture_.gas_constant_sum / point_.mass;
  double growth = closed_pressure_growth(t) -
                  point_.gamma * gas_constant * point_.temperature * (point_.vent + point_.fabric);
  if (point_.back > 0.0) growth += point_.back * pressure_growth(air_, model_.ambient.temperature, point_);
  return growth / point_.volume;
}

double FlowBalance::relaxation_rate() const {
  const double p_a = ambient_pressure(), flow = point_.vent + point_.fabric;
  if (!(flow > 0.0)) return 0.0;
  const double vent = point_.vent * orifice_pressure_exponent(point_.gamma, p_a / point_.pressure);
  const double fabric = point_.fabric * (0.5 + 0.5 * point_.pressure / (point_.pressure - p_a));
  return outflow_relaxation_rate(point_.gamma, flow / point_.mass, (vent + fabric) / flow);
}

}  // namespace gas
