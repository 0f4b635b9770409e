// SPDX-License-Identifier: Apache-2.0
#include "first_gas.hpp"

#include <algorithm>
#include <limits>

namespace gas {
namespace {

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

/// Work against its pressure is of second order in its mass. The balance is the equation of a mixture with h A
/// added to its cp. None without inflow, or if T is out of range.
std::optional<double> balance_with_walls(const Boundary& boundary, double backflow, double t) {
  const HeatLoss& loss = boundary.model().heat_loss;
  Mixture sum;
  double energy = loss.conductance * loss.outside_temperature, flow = 0.0;
  const Inflows& inflows = boundary.inflows();
  for (std::size_t i = 0; i < inflows.size(); ++i) {
    if (inflows[i].is_idle()) continue;
    const auto [mass_flow, temperature] = inflows[i].flow(t);
    energy += mass_flow * inflows[i].gas().enthalpy(temperature);
    add(mass_flow, inflows[i].gas(), sum);
    flow += mass_flow;
  }
  if (backflow > 0.0) {
    energy += backflow * boundary.ambient().enthalpy;
    add(backflow, boundary.ambient().mixture, sum);
    flow += backflow;
  }
  if (flow == 0.0) return {};
  sum.low[0] += loss.conductance;
  sum.high[0] += loss.conductance;
  return sum.find_temperature(energy, loss.outside_temperature);
}

}  // namespace

double fill_first(System& system, const IntegratorOptions& options, Vector& y, double t, double b) {
  Balance& balance = system.balance;
  const Boundary& boundary = balance.boundary();
  const Slots& s = boundary.slots();
  const UniformGas empty = balance.gas();
  // Into no gas ambient gas flows sonic, linear in time as areas are.
  const auto back = [&](std::size_t j, double end) {
    return 0.5 * (boundary.back(j, empty, t) + boundary.back(j, empty, end)) * (end - t);
  };
  const auto mass_until = [&](double end) {
    double mass = boundary.inflows().mass(t, end);
    for (std::size_t j = 0; j < s.backflows; ++j) mass += back(j, end);
    return mass;
  };
  const double all = mass_until(b), fixed = options.fixed_step;
  if (!(all > 0.0)) return t;
  double length = fixed > 0.0 ? std::min(fixed, b - t) : b - t;
  const double least = 16.0 * std::numeric_limits<double>::epsilon() * std::abs(t);
  while (fixed == 0.0 && length > least && mass_until(t + length) > options.relative_tolerance * all) length *= 0.5;
  const double end = length == b - t ? b : t + length;
  double backflow = 0.0;
  std::ranges::fill(y, 0.0);
  for (std::size_t j = 0; j < s.backflows; ++j) {
    y[s.back(j)] = back(j, end);
    backflow += boundary.back(j, empty, end);
  }
  const auto temperature = balance_with_walls(boundary, backflow, end);
  if (!temperature) return t;
  system.ledger.gas_at(y, end, system.gas);
  const Mixture mixture = boundary.model().thermo.mixture(std::span(system.gas).first(s.species));
  y[s.heat()] = system.gas.back() - mixture.internal_energy(*temperature) - balance.work_at(mixture, *temperature);
  system.ledger.accept(y, end);
  return end;
}

}  // namespace gas
