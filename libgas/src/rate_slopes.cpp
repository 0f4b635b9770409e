// SPDX-License-Identifier: Apache-2.0
#include "rate_slopes.hpp"

#include <algorithm>
#include <cmath>

#include "gas/orifice.hpp"

namespace gas {
namespace {

UniformGas moved(const Balance& balance, double overpressure) {
  UniformGas gas = balance.gas();
  gas.overpressure = overpressure;
  gas.pressure = balance.boundary().model().ambient.pressure + overpressure;
  return gas;
}

}  // namespace

double balanced_overpressure(const Balance& balance) {
  const Boundary& boundary = balance.boundary();
  const Slots& s = boundary.slots();
  const UniformGas& gas = balance.gas();
  const double growth = balance.closed_growth() * gas.compliance(),
               laminar = laminar_overpressure(boundary.model());
  if (gas.mass == 0.0 || growth == 0.0) return 0.0;
  // What the openings do to V dp/dt where the law is that of the root, and from it where they balance the
  // feed.
  const double sign = growth > 0.0 ? 1.0 : -1.0, far = std::max(std::abs(gas.overpressure), 100.0 * laminar);
  const UniformGas there = moved(balance, sign * far);
  double flow = 0.0;
  for (std::size_t j = 0; j < (growth > 0.0 ? s.streams() : s.backflows); ++j)
    flow += growth > 0.0 ? boundary.out(j, there, balance.time()) : boundary.back(j, there, balance.time());
  const AmbientGas& air = boundary.ambient();
  const double effect = flow * (growth > 0.0 ? gas.gamma * gas.gas_constant * gas.temperature
                                             : growth_per_flow(air.mixture, air.temperature, gas));
  if (!(effect > 0.0)) return 0.0;
  const double root = std::abs(growth) / effect * std::sqrt(far);
  double overpressure = root * root;
  // (G.22): root = p^2/(p^2 + d^2)^(3/4), by iterations that leave at most 3/4 of the error.
  for (int i = 0; i < 8 && overpressure < 10.0 * laminar; ++i)
    overpressure = std::sqrt(root) * std::pow(overpressure * overpressure + laminar * laminar, 0.375);
  return sign * overpressure;
}

UniformGas where_linear(const Balance& balance) {
  // Farther from p_a the slope no longer changes by much within a sub-step.
  constexpr double kClose = 1e-3;  // of p_a
  const UniformGas& gas = balance.gas();
  const double close = kClose * balance.boundary().model().ambient.pressure;
  if (std::abs(gas.overpressure) > close) return gas;
  const double balanced = balanced_overpressure(balance);
  return std::abs(balanced) > std::abs(gas.overpressure) && std::abs(balanced) < close
             ? moved(balance, balanced)
             : gas;
}

double relaxation(const Balance& balance, const UniformGas& gas) {
  const Boundary& boundary = balance.boundary();
  const Slots& s = boundary.slots();
  if (gas.mass == 0.0) return 0.0;
  const double walls = boundary.model().heat_loss.conductance / gas.capacity;
  if (gas.overpressure > 0.0) {
    Flow all{};
    for (std::size_t j = 0; j < s.streams(); ++j) {
      const Flow one = boundary.out_slopes(j, gas, balance.time());
      all.value += one.value;
      all.pressure += one.pressure;
    }
    if (!(all.value > 0.0)) return walls;
    return walls + outflow_relaxation_rate(gas.gamma, all.value / gas.mass,
                                           all.pressure * gas.pressure / all.value, gas.compliance());
  }
  double slope = 0.0;
  for (std::size_t j = 0; j < s.backflows; ++j)
    slope += boundary.back_slopes(j, gas, balance.time()).pressure;
  if (!(slope < 0.0)) return walls;
  const AmbientGas& air = boundary.ambient();
  const double effect = -slope * growth_per_flow(air.mixture, air.temperature, gas);
  return walls + std::max(0.0, effect / (gas.compliance() * gas.volume));
}

RateSlopes::RateSlopes(const Slots& slots)
    : by_part(slots.species + 1, Vector(slots.size())),
      by_time(slots.size()),
      part_energy(slots.species + 1),
      changes_(slots.species + 1) {}

void RateSlopes::fill_changes(const Balance& balance, const UniformGas& g) {
  const Thermo& thermo = balance.boundary().model().thermo;
  const double cv = g.cp - g.gas_constant, per_energy = g.pressure_per_energy();
  const std::size_t species = thermo.size();
  for (std::size_t k = 0; k < species; ++k) {
    const double rt = thermo.gas_constant(k) * g.temperature, h = thermo.enthalpy(k, g.temperature);
    const double r = (thermo.gas_constant(k) - g.gas_constant) / g.mass,
                 cp = (thermo.cp(k, g.temperature) - g.cp) / g.mass;
    changes_[k] = {rt * per_energy, 0.0, r, (g.cp * r - g.gas_constant * cp) / (cv * cv),
                   (h - g.enthalpy) / g.mass};
    part_energy[k] = h - rt + GasLocator::work_share(g) * rt;
  }
  const double per_capacity = 1.0 / g.capacity;
  const double cp_slope = balance.mixture().cp_slope(g.temperature) / g.mass;
  changes_[species] = {g.mass * g.gas_constant * per_energy * per_capacity, per_capacity, 0.0,
                       -g.gas_constant * cp_slope / (cv * cv) * per_capacity, g.cp * per_capacity};
  part_energy[species] = 1.0;
}

void RateSlopes::add_outflow(const Balance& balance, const UniformGas& g, double pressure_by_time) {
  const Boundary& boundary = balance.boundary();
  const Slots& s = boundary.slots();
  for (std::size_t j = 0; j < s.streams(); ++j) {
    const Flow flow = boundary.out_slopes(j, g, balance.time());
    const double time = flow.time + flow.pressure * pressure_by_time;
    by_time[s.mass(j)] = time;
    by_time[s.enthalpy(j)] = time * g.enthalpy;
    for (std::size_t k = 0; k < s.species; ++k) by_time[s.out(k)] += time * balance.fraction(k);
    for (std::size_t part = 0; part < by_part.size(); ++part) {
      const double change = changes_[part].of(flow);
      by_part[part][s.mass(j)] = change;
      by_part[part][s.enthalpy(j)] = change * g.enthalpy + flow.value * changes_[part].enthalpy;
      for (std::size_t k = 0; k < s.species; ++k) {
        const double fraction = balance.fraction(k);
        const double of_fraction = part == s.species ? 0.0 : ((part == k ? 1.0 : 0.0) - fraction) / g.mass;
        by_part[part][s.out(k)] += change * fraction + flow.value * of_fraction;
      }
    }
  }
}

void RateSlopes::fill(const Balance& balance) {
  const Boundary& boundary = balance.boundary();
  const Slots& s = boundary.slots();
  const UniformGas g = where_linear(balance);
  for (Vector& column : by_part) std::ranges::fill(column, 0.0);
  std::ranges::fill(by_time, 0.0);
  std::ranges::fill(part_energy, 0.0);
  part_energy.back() = 1.0;
  if (g.mass == 0.0) return;
  fill_changes(balance, g);
  const double t = balance.time(), rate = boundary.path().rate(t);
  const double pressure_by_time = -g.pressure * rate / g.volume;
  if (g.overpressure > 0.0) add_outflow(balance, g, pressure_by_time);
  for (std::size_t j = 0; g.overpressure < 0.0 && j < s.backflows; ++j) {
    const Flow flow = boundary.back_slopes(j, g, t);
    by_time[s.back(j)] = flow.time + flow.pressure * pressure_by_time;
    for (std::size_t part = 0; part < by_part.size(); ++part)
      by_part[part][s.back(j)] = changes_[part].of(flow);
  }
  by_time[s.work()] = rate * pressure_by_time + g.pressure * boundary.path().acceleration();
  for (std::size_t part = 0; part < by_part.size(); ++part) {
    by_part[part][s.work()] = rate * changes_[part].pressure;
    by_part[part][s.heat()] = boundary.model().heat_loss.conductance * changes_[part].temperature;
  }
}

}  // namespace gas
