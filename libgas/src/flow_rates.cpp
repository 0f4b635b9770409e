// SPDX-License-Identifier: Apache-2.0
// Rates of the pressure that the integrator's events need, the gas's own relaxation rate.
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

}  // namespace

double FlowBalance::closed_pressure_growth(double t) const {
  double growth = -point_.gamma * point_.pressure * volume_rate(t) - (point_.gamma - 1.0) * point_.heat;
  for (const InflowSegment& segment : segments_) {
    const auto [mass_flow, temperature] = segment.flow(t);
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
  const double flow = point_.vent + point_.fabric;
  if (is_held()) return (flow + point_.back) / point_.mass;  // p is no part of it
  if (regime_ == Regime::kBack && point_.back > 0.0)         // as the root of p_a - p, which it is near p_a
    return point_.back * pressure_growth(air_, model_.ambient.temperature, point_) /
           (2.0 * point_.compliance * point_.volume * -point_.overpressure);
  if (!(flow > 0.0)) return 0.0;
  const double share = point_.overpressure / point_.pressure;
  const double vent = point_.vent * orifice_pressure_exponent(point_.gamma, share);
  const double fabric = point_.fabric * fabric_pressure_exponent(share);
  return outflow_relaxation_rate(point_.gamma, flow / point_.mass, (vent + fabric) / flow, point_.compliance);
}

}  // namespace gas
