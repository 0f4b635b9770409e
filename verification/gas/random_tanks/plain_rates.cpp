// SPDX-License-Identifier: Apache-2.0
#include "plain_rates.hpp"

#include <algorithm>
#include <numeric>

namespace random_tanks {
namespace {

constexpr double kLaminarShare = 1e-8;  // d / p_a of (G.22)

}  // namespace

PlainRates::PlainRates(const Tank& tank, const std::string& csv)
    : tank_(tank), species_(read_species(tank.gases, csv)), laminar_(kLaminarShare * tank.ambient_pressure) {
  for (const PlainSpecies& s : species_) {
    minimum_ = std::max(minimum_, s.minimum);
    maximum_ = std::min(maximum_, s.maximum);
  }
  const auto add = [this](const Table& table) {
    knots_.insert(knots_.end(), table.x.begin(), table.x.end());
  };
  for (const Hole& hole : tank.holes) add(hole.area_of_overpressure);
  add(tank.fabric_velocity);
  add(tank.volume_of_overpressure);
  const double t = tank.ambient_temperature;
  for (std::size_t k = 0; k < species_.size(); ++k)
    ambient_constant_ += tank.ambient[k] * species_[k].gas_constant;
  const double cp = polynomial_cp(sum(t > kJoint, tank.ambient), t);
  ambient_gamma_ = cp / (cp - ambient_constant_);
  ambient_enthalpy_ = enthalpy(tank.ambient, t);
}

Coefficients PlainRates::sum(bool upper, std::span<const double> masses) const {
  Coefficients result{};
  for (std::size_t k = 0; k < species_.size(); ++k)
    for (std::size_t j = 0; j < result.size(); ++j)
      result[j] += masses[k] * (upper ? species_[k].upper : species_[k].lower)[j];
  return result;
}

double PlainRates::enthalpy(std::span<const double> masses, double temperature) const {
  return polynomial_enthalpy(sum(temperature > kJoint, masses), temperature, minimum_, maximum_);
}

template <class Real>
Real PlainRates::outflow(double t, const PlainState<Real>& gas) const {
  const auto& [p, dp, volume, work] = gas.place;
  if (!(value_of(gas.mass) > 0.0 && value_of(dp) > 0.0)) return 0.0;
  const Real r = gas.gas_constant_sum / gas.mass, gamma = gas.cp_sum / (gas.cp_sum - gas.gas_constant_sum);
  const Real flux = hole_flow(p, dp, gas.temperature, r, gamma, laminar_);
  Real flow = 0.0;
  for (std::size_t j = 0; j < tank_.holes.size(); ++j) {
    const Table& table = tank_.holes[j].area_of_overpressure;
    Real area = std::max(0.0, stretch.areas[j].at(t));
    if (!table.empty()) area = area * table_of(table, dp);
    flow += area * flux;
  }
  const double leak = std::max(0.0, stretch.leak.at(t));
  if (leak == 0.0) return flow;
  const Real density = gas.mass / volume;
  if (tank_.fabric_velocity.empty()) return flow + leak * screen_flow(density, dp, laminar_);
  return flow + leak * density * table_of(tank_.fabric_velocity, dp);
}

template <class Real>
Real PlainRates::backflow(double t, const PlainState<Real>& gas) const {
  const Real deficit = -gas.place.overpressure;
  if (!(value_of(deficit) > 0.0)) return 0.0;
  const Real flux = hole_flow<Real>(tank_.ambient_pressure, deficit, tank_.ambient_temperature,
                                    ambient_constant_, ambient_gamma_, laminar_);
  Real flow = 0.0;
  for (std::size_t j = 0; j < tank_.holes.size(); ++j) {
    if (!tank_.holes[j].backflow) continue;
    const Table& table = tank_.holes[j].area_of_overpressure;
    Real area = std::max(0.0, stretch.areas[j].at(t));
    if (!table.empty()) area = area * table.y.front();  // their first knots are at p_a or above
    flow += area * flux;
  }
  return flow;
}

template <class Real>
bool PlainRates::evaluate(double t, std::span<const Real> y, std::span<Real> dydt) const {
  const std::size_t n = species_.size();
  PlainState<Real> gas;
  if (!find(t, y, gas)) return false;
  for (Real& d : dydt) d = 0.0;
  for (std::size_t i = 0; i < tank_.pulses.size(); ++i) {
    const double flow = stretch.flows[i].at(t);
    if (!(flow > 0.0)) continue;
    for (std::size_t k = 0; k < n; ++k) dydt[k] += flow * tank_.pulses[i].fractions[k];
    dydt[n] += flow * enthalpy(tank_.pulses[i].fractions, stretch.temperatures[i].at(t));
  }
  const Real back = backflow(t, gas);
  for (std::size_t k = 0; k < n; ++k) dydt[k] += back * tank_.ambient[k];
  dydt[n] += back * ambient_enthalpy_;
  if (!(value_of(gas.mass) > 0.0)) return true;
  const Real share = outflow(t, gas) / gas.mass;
  for (std::size_t k = 0; k < n; ++k) dydt[k] -= share * y[k];
  const auto& [p, dp, volume, work] = gas.place;
  dydt[n] -= share * (y[n] - work + p * volume);
  if (tank_.volume_of_overpressure.empty()) {
    const double x = (stretch.since + t) / stretch.length;
    dydt[n] -= p * (stretch.volume.slope + 4.0 * stretch.bulge * (1.0 - 2.0 * x) / stretch.length);
  }
  dydt[n] -= tank_.conductance * (gas.temperature - tank_.outside_temperature);
  return true;
}

bool PlainRates::rates(double t, std::span<const double> y, std::span<double> dydt) const {
  return evaluate(t, y, dydt);
}

bool PlainRates::jacobian(double t, std::span<const double> y, std::span<double> dydt,
                          std::span<double> jacobian) const {
  const std::size_t n = size();
  std::array<Dual, kMostUnknowns> point, rate;
  for (std::size_t i = 0; i < n; ++i) {
    point[i] = Dual(y[i]);
    point[i].slope[i] = 1.0;
  }
  if (!evaluate<Dual>(t, std::span<const Dual>(point.data(), n), std::span<Dual>(rate.data(), n)))
    return false;
  for (std::size_t i = 0; i < n; ++i) {
    dydt[i] = rate[i].value;
    for (std::size_t j = 0; j < n; ++j) jacobian[i * n + j] = rate[i].slope[j];
  }
  return true;
}

}  // namespace random_tanks
