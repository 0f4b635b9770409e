// SPDX-License-Identifier: Apache-2.0
#include "tank_gas.hpp"

#include <algorithm>
#include <cmath>
#include <elementary/exponential.hpp>

#include "gas/orifice.hpp"
#include "require.hpp"

namespace gas {
namespace {

// Range of the search for gases of constant cp, whose own range is unlimited.
constexpr double kLowest = 1.0, kHighest = 1e5;  // [K]
// Newton steps in ln T; quadratic except for the slope of gamma(T), which is neglected.
constexpr int kMostSteps = 60;
constexpr double kTemperatureSettled = 1e-13;
constexpr double kLeastSlope = 0.05;
constexpr double kGuess = 600.0;  // [K]

Mixture amount(const Thermo& thermo, std::span<const double> fractions, double mass) {
  std::vector<double> masses(fractions.begin(), fractions.end());
  for (double& m : masses) m *= mass;
  return thermo.mixture(masses);
}

/// Root of a rising function within bounds; the nearest bound if there is none. `function` gives value and
/// slope. Newton's method, with bisection where it leaves the bracket.
template <typename Function>
double rising_root(double low, double high, double guess, const Function& function) {
  double x = std::clamp(guess, low, high);
  for (int i = 0; i < kMostSteps && low < high; ++i) {
    const auto [value, slope] = function(x);
    (value > 0.0 ? high : low) = x;
    double next = x - value / slope;
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    if (std::abs(next - x) <= kTemperatureSettled * std::abs(x)) return next;
    x = next;
  }
  return x;
}

}  // namespace

TankGas::TankGas(const TankTest& test, double initial_pressure, double conductance)
    : volume_(test.volume),
      initial_temperature_(test.initial_temperature),
      conductance_(conductance),
      own_(amount(test.thermo, test.tank_fractions,
                  initial_pressure * test.volume /
                      (test.thermo.gas_constant(test.tank_fractions) * test.initial_temperature))),
      inflator_(test.thermo.mixture(test.inflator_fractions)),
      range_{std::max(kLowest, test.thermo.minimum_temperature()),
             std::min(kHighest, test.thermo.maximum_temperature())},
      initial_energy_(own_.internal_energy(test.initial_temperature)) {}

TankGas::Rate TankGas::rate(double time, double p, double dp, double m) const {
  const double gas_constant = own_.gas_constant_sum + m * inflator_.gas_constant_sum;
  const double t = temperature(p, m);
  if (!(t >= range_.low && t <= range_.high))
    throw DomainError("tank test: at " + to_short_text(time) + " s the gas in the tank is at " +
                      to_text_beside(t, t < range_.low ? range_.low : range_.high) + " K, outside " +
                      to_text(range_.low) + " to " + to_text(range_.high) +
                      " K: pressures, volume and mass do not fit");
  const double cv = own_.cv(t) + m * inflator_.cv(t);
  return {cv * volume_ * dp / gas_constant + heat(p, m),
          cv * t * inflator_.gas_constant_sum / gas_constant - inflator_.internal_energy(t)};
}

double TankGas::energy(double p, double m) const {
  const double t = temperature(p, m);
  return own_.internal_energy(t) + m * inflator_.internal_energy(t);
}

double TankGas::adiabatic_rate(double p, double dp, double m) const {
  const double t = std::clamp(temperature(p, m), range_.low, range_.high);
  const double sum = own_.gas_constant_sum + m * inflator_.gas_constant_sum;
  return dp + heat(p, m) * sum / (volume_ * (own_.cv(t) + m * inflator_.cv(t)));
}

double TankGas::mean_enthalpy(double p, double m, double lost) const {
  return (energy(p, m) - initial_energy_ + lost) / m;
}

double TankGas::delivered(double p, double enthalpy, double lost, double most, double guess) const {
  const auto mass_at = [&](double t) {
    return std::clamp((p * volume_ / t - own_.gas_constant_sum) / inflator_.gas_constant_sum, 0.0, most);
  };
  return rising_root(mass_at(range_.high), mass_at(range_.low), guess, [&](double m) {
    const double t = temperature(p, m), sum = own_.gas_constant_sum + m * inflator_.gas_constant_sum;
    const double cv = own_.cv(t) + m * inflator_.cv(t);
    return std::pair(enthalpy * m + initial_energy_ - energy(p, m) - lost,
                     enthalpy - inflator_.internal_energy(t) + cv * t * inflator_.gas_constant_sum / sum);
  });
}

double TankGas::inflow_temperature(double enthalpy) const {
  if (!(enthalpy >= inflator_.enthalpy(range_.low) && enthalpy <= inflator_.enthalpy(range_.high)))
    throw DomainError("tank test: the mean temperature of the inflow is outside " + to_text(range_.low) +
                      " to " + to_text(range_.high) + " K: pressures, volume and mass do not fit");
  return rising_root(range_.low, range_.high, kGuess,
                     [&](double t) { return std::pair(inflator_.enthalpy(t) - enthalpy, inflator_.cp(t)); });
}

double TankGas::outlet_flow(double area, double temperature, double chamber, double tank) const {
  const double cp = inflator_.cp(temperature), gas_constant = inflator_.gas_constant_sum;
  return orifice_mass_flow(area, chamber, temperature, gas_constant, cp, cp / (cp - gas_constant), tank);
}

double TankGas::stagnation_temperature(const Rate& rate, double area, double chamber, double tank,
                                       double guess) const {
  if (!(rate.power > 0.0)) return range_.low;
  if (!(chamber > tank)) return range_.high;  // nothing flows however hot
  double t = std::clamp(guess, range_.low, range_.high);
  for (int i = 0; i < kMostSteps; ++i) {
    const double content = inflator_.enthalpy(t) + rate.offset;
    const double excess = outlet_flow(area, t, chamber, tank) * content / rate.power;
    // d ln(excess)/d ln T; the outlet flow goes with T^(-1/2).
    const double slope = std::max(kLeastSlope, inflator_.cp(t) * t / content - 0.5);
    const double step = excess > 0.0 ? std::clamp(-elementary::log(excess) / slope, -1.0, 1.0) : 1.0;
    const double next = std::clamp(t * elementary::exp(step), range_.low, range_.high);
    if (std::abs(next - t) <= kTemperatureSettled * t) return next;
    t = next;
  }
  return t;
}

double TankGas::gamma_r(double temperature) const {
  const double cp = inflator_.cp(temperature);
  return cp / (cp - inflator_.gas_constant_sum) * inflator_.gas_constant_sum;
}

}  // namespace gas
