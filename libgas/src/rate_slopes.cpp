// SPDX-License-Identifier: Apache-2.0
#include "rate_slopes.hpp"

#include <algorithm>
#include <cmath>
#include <elementary/exponential.hpp>

#include "gas/orifice.hpp"
#include "limits.hpp"

namespace gas {
namespace {

UniformGas moved(const Balance& balance, double overpressure) {
  UniformGas gas = balance.gas();
  gas.overpressure = overpressure;
  gas.pressure = balance.boundary().model().ambient.pressure + overpressure;
  return gas;
}

/// The gas whose Jacobian a sub-step needs. In the laminar range the slope changes within a sub-step; beyond
/// it another gas than the one that is there would cost the method its order.
UniformGas where_differentiated(const Balance& balance) {
  constexpr double kLaminar = 10.0;  // times its width
  const double laminar = laminar_overpressure(balance.boundary().model());
  return std::abs(balance.gas().overpressure) > kLaminar * laminar ? balance.gas() : where_linear(balance);
}

/// Bound of the relaxation rate by the flow alone; infinite where there is none.
double relaxation_bound(const Balance& balance) {
  constexpr double kFar = 1e-3;  // share of p: nearer to p_a the flow does not bound its slope
  const UniformGas& gas = balance.gas();
  const ControlVolumeModel& model = balance.boundary().model();
  if (!(gas.overpressure > kFar * gas.pressure) ||
      std::ranges::any_of(model.vents, [](const Vent& v) { return v.area_of_overpressure.has_value(); }) ||
      std::ranges::any_of(model.fabrics, [](const Fabric& f) { return f.velocity.has_value(); }))
    return kInfinity;
  // The exponent n of a hole is at most 1/2 p/(p - p_a) + 1, that of fabric 1/2 less.
  const double exponent = 1.0 + 0.5 * gas.pressure / gas.overpressure;
  return wall_relaxation(balance) + balance.flow() / gas.mass * (1.0 + gas.gamma * (exponent + 0.5));
}

}  // namespace

double balanced_overpressure(const Balance& balance) {
  const Boundary& boundary = balance.boundary();
  const UniformGas& gas = balance.gas();
  const double growth = balance.closed_growth(), laminar = laminar_overpressure(boundary.model());
  if (gas.mass == 0.0 || growth == 0.0) return 0.0;
  // Effect of the openings on V dp/dt at a distance from p_a where the square-root law holds. From it follows
  // where they balance the feed.
  const double sign = growth > 0.0 ? 1.0 : -1.0, far = std::max(std::abs(gas.overpressure), 100.0 * laminar);
  const double flow = boundary.flow(moved(balance, sign * far).upstream(), balance.time());
  const double effect = -sign * balance.open_growth(flow);
  if (!(effect > 0.0)) return 0.0;
  const double root = std::abs(growth) / effect * std::sqrt(far);
  double overpressure = root * root;
  // (G.22): root = p^2/(p^2 + d^2)^(3/4), by iterations that leave at most 3/4 of the error.
  for (int i = 0; i < 8 && overpressure < 10.0 * laminar; ++i)
    overpressure = std::sqrt(root) * elementary::pow(overpressure * overpressure + laminar * laminar, 0.375);
  return sign * overpressure;
}

UniformGas where_linear(const Balance& balance) {
  // Farther from p_a the slope hardly changes within a sub-step.
  constexpr double kClose = 1e-3;  // of p_a
  const UniformGas& gas = balance.gas();
  const double close = kClose * balance.boundary().model().ambient.pressure;
  if (std::abs(gas.overpressure) > close) return gas;
  const double balanced = balanced_overpressure(balance);
  return std::abs(balanced) > std::abs(gas.overpressure) && std::abs(balanced) < close
             ? moved(balance, balanced)
             : gas;
}

double wall_relaxation(const Balance& balance) {
  const UniformGas& gas = balance.gas();
  return gas.mass > 0.0 ? balance.boundary().model().heat_loss.conductance / gas.capacity : 0.0;
}

double relaxation(const Balance& balance, double enough) {
  using Number = Dual<1>;
  if (const double bound = relaxation_bound(balance); bound <= enough) return bound;
  const Boundary& boundary = balance.boundary();
  const UniformGas gas = where_linear(balance);
  const Number flow = boundary.flow<Number>(
      {{gas.pressure, 0}, {gas.overpressure, 0}, gas.temperature, gas.gas_constant, gas.gamma},
      balance.time());
  const double slope = flow.slopes[0], walls = wall_relaxation(balance);
  if (flow.value == 0.0) return walls;
  if (flow.value < 0.0) return walls + std::max(0.0, balance.open_growth(-slope) / gas.volume);
  return walls + outflow_relaxation_rate(gas.gamma, flow.value / gas.mass, slope * gas.pressure / flow.value,
                                         gas.compliance());
}

RateSlopes::RateSlopes(const Slots& slots)
    : by_part(slots.species + 1, Vector(slots.size())),
      by_time(slots.size()),
      part_energy(slots.species),
      changes_(slots.species + 2) {}

/// Derivatives of the variables by the parts (G.23) and by time.
void RateSlopes::fill_changes(const Balance& balance, const UniformGas& g) {
  const Boundary& boundary = balance.boundary();
  const Thermo& thermo = boundary.model().thermo;
  const double cv = g.cp - g.gas_constant, per_energy = g.pressure_per_energy();
  const std::size_t species = thermo.size();
  for (std::size_t k = 0; k < species; ++k) {
    const double rt = thermo.gas_constant(k) * g.temperature, h = thermo.enthalpy(k, g.temperature);
    const double r = (thermo.gas_constant(k) - g.gas_constant) / g.mass,
                 cp = (thermo.cp(k, g.temperature) - g.cp) / g.mass;
    changes_[k] = {{rt * per_energy, 0.0, r, (g.cp * r - g.gas_constant * cp) / (cv * cv), 0.0},
                   (h - g.enthalpy) / g.mass};
    part_energy[k] = h - rt + g.work_share() * rt;
  }
  const double per_capacity = 1.0 / g.capacity;
  const double cp_slope = balance.mixture().cp_slope(g.temperature) / g.mass;
  changes_[species] = {{g.mass * g.gas_constant * per_energy * per_capacity, per_capacity, 0.0,
                        -g.gas_constant * cp_slope / (cv * cv) * per_capacity, 0.0},
                       g.cp * per_capacity};
  changes_.back() = {{-g.pressure * boundary.path().rate(balance.time()) / g.volume, 0.0, 0.0, 0.0, 1.0},
                     0.0};
}

void RateSlopes::fill(const Balance& balance) {
  const Boundary& boundary = balance.boundary();
  const Slots& s = boundary.slots();
  const UniformGas g = where_differentiated(balance);
  for (Vector& column : by_part) std::ranges::fill(column, 0.0);
  std::ranges::fill(by_time, 0.0);
  std::ranges::fill(part_energy, 0.0);
  if (g.mass == 0.0) return;
  fill_changes(balance, g);
  const auto variable = [](double value, Variable v) { return Number(value, v); };
  const Number t = variable(balance.time(), kTime);
  const Upstream<Number> gas{variable(g.pressure, kPressure), variable(g.overpressure, kPressure),
                             variable(g.temperature, kTemperature), variable(g.gas_constant, kGasConstant),
                             variable(g.gamma, kGamma)};
  const auto for_each_column = [&](auto visit) {
    for (std::size_t part = 0; part < changes_.size(); ++part)
      visit(part < by_part.size() ? by_part[part] : by_time, changes_[part], part);
  };
  for_each_column([&](Vector& column, const Change& change, std::size_t) {
    column[s.work()] = boundary.path().rate(balance.time()) * change.variables[kPressure] +
                       g.pressure * boundary.path().acceleration() * change.variables[kTime];
    column[s.heat()] = boundary.model().heat_loss.conductance * change.variables[kTemperature];
  });
  for (std::size_t j = 0; g.overpressure > 0.0 && j < s.streams(); ++j) {
    const Number flow = boundary.out(j, gas, t);
    for_each_column([&](Vector& column, const Change& change, std::size_t part) {
      // One number for all slots: columns that flow alone makes must be proportional to the last bit, or
      // stiff gas amplifies the rounding.
      const double by = column[s.mass(j)] = flow.along(change.variables);
      column[s.enthalpy(j)] = by * g.enthalpy + flow.value * change.enthalpy;
      for (std::size_t k = 0; k < s.species; ++k) {
        const double y = balance.fraction(k);
        const double of_y = part < s.species ? ((part == k ? 1.0 : 0.0) - y) / g.mass : 0.0;
        column[s.out(k)] += by * y + flow.value * of_y;
      }
    });
  }
  for (std::size_t j = 0; g.overpressure < 0.0 && j < s.backflows; ++j) {
    const Number flow = boundary.back(j, gas, t);
    for_each_column([&](Vector& column, const Change& change, std::size_t) {
      column[s.back(j)] = flow.along(change.variables);
    });
  }
}

}  // namespace gas
