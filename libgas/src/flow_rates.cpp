// SPDX-License-Identifier: Apache-2.0
// Rates of the pressure that the integrator's events need, the gas's own relaxation rate, heat of the first
// gas.
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

/// The temperature at which inflow and walls balance while an evacuated volume begins to fill, sum mdot_i
/// (h_i - u_i(T)) = h A (T - T_ext), which is the equation of a mixture with h A added to its cp. None
/// without inflow.
std::optional<double> FlowBalance::temperature_of_first_gas(double t) const {
  const HeatLoss& loss = model_.heat_loss;
  Mixture sum;
  double energy = loss.conductance * loss.outside_temperature, flow = 0.0;
  for (const InflowSegment& segment : segments_) {
    const auto [mass_flow, temperature] = segment.flow(t - segment_begin_);
    if (!(mass_flow > 0.0)) continue;
    energy += mass_flow * segment.gas().enthalpy(temperature);
    add(mass_flow, segment.gas(), sum);
    flow += mass_flow;
  }
  if (point_.back > 0.0) {
    energy += point_.back * air_enthalpy_;
    add(point_.back, air_, sum);
    flow += point_.back;
  }
  if (flow == 0.0) return {};
  sum.low[0] += loss.conductance;
  sum.high[0] += loss.conductance;
  return sum.find_temperature(energy, loss.outside_temperature);
}

void FlowBalance::fill_until(Vector& y, const Vector& dydt, double begin, double end) {
  for (std::size_t j = 0; j < backflows(); ++j) y[back_slot(j)] += dydt[back_slot(j)] * (end - begin);
  const double energy = collect(y, end);
  model_.thermo.mixture(masses_, mixture_);
  if (const auto temperature = temperature_of_first_gas(end))
    y[heat_slot()] += energy - mixture_.internal_energy(*temperature);
}

double FlowBalance::mass_in_until(double t) const {
  double mass = 0.0;
  for (const InflowSegment& segment : segments_) mass += segment.delivered(t - segment_begin_).mass;
  return mass + point_.back * (t - segment_begin_);
}

double FlowBalance::closed_pressure_growth(double t) const {
  double growth = -point_.gamma * point_.pressure * volume_rate(t) - (point_.gamma - 1.0) * point_.heat;
  for (const InflowSegment& segment : segments_) {
    const auto [mass_flow, temperature] = segment.flow(t - segment_begin_);
    if (mass_flow > 0.0) growth += mass_flow * pressure_growth(segment.gas(), temperature, point_);
  }
  return growth / point_.compliance;
}

double FlowBalance::pressure_rate(double t) const {
  if (point_.mass == 0.0) return 0.0;
  const double gas_constant = mixture_.gas_constant_sum / point_.mass;
  double growth = -point_.gamma * gas_constant * point_.temperature * (point_.vent + point_.fabric);
  if (point_.back > 0.0) growth += point_.back * pressure_growth(air_, model_.ambient.temperature, point_);
  return (closed_pressure_growth(t) + growth / point_.compliance) / point_.volume;
}

double FlowBalance::heat_rate() const {
  if (point_.mass == 0.0) return 0.0;
  return model_.heat_loss.conductance * point_.temperature / point_.thermal_energy;
}

double FlowBalance::relaxation_rate() const {
  const double p_a = ambient_pressure(), flow = point_.vent + point_.fabric;
  if (regime_ == Regime::kBack && point_.back > 0.0)  // as the root of p_a - p, which it is near p_a
    return point_.back * pressure_growth(air_, model_.ambient.temperature, point_) /
           (2.0 * point_.compliance * point_.volume * (p_a - point_.pressure));
  if (!(flow > 0.0)) return 0.0;
  const double vent = point_.vent * orifice_pressure_exponent(point_.gamma, p_a / point_.pressure);
  const double fabric = point_.fabric * fabric_pressure_exponent(point_.pressure, p_a);
  return outflow_relaxation_rate(point_.gamma, flow / point_.mass, (vent + fabric) / flow, point_.compliance);
}

}  // namespace gas
