// SPDX-License-Identifier: Apache-2.0
#include "tank_gas.hpp"

#include <algorithm>
#include <cmath>

#include "gas/orifice.hpp"
#include "require.hpp"

namespace gas {
namespace {

// Where gases of constant cp, which have every temperature, are looked for.
constexpr double kLowest = 1.0, kHighest = 1e5;  // [K]
// Newton steps in ln T; quadratic but for the slope of gamma(T), which is left out.
constexpr int kMostSteps = 60;
constexpr double kTemperatureSettled = 1e-13;
constexpr double kLeastSlope = 0.05;

Mixture amount(const Thermo& thermo, std::span<const double> fractions, double mass) {
  std::vector<double> masses(fractions.begin(), fractions.end());
  for (double& m : masses) m *= mass;
  return thermo.mixture(masses);
}

}  // namespace

TankGas::TankGas(const TankTest& test, double initial_pressure)
    : volume_(test.volume),
      own_(amount(test.thermo, test.tank_fractions,
                  initial_pressure * test.volume /
                      (test.thermo.gas_constant(test.tank_fractions) * test.initial_temperature))),
      inflator_(test.thermo.mixture(test.inflator_fractions)),
      range_{std::max(kLowest, test.thermo.minimum_temperature()),
             std::min(kHighest, test.thermo.maximum_temperature())} {}

TankGas::Rate TankGas::rate(double time, double p, double dp, double m) const {
  const double gas_constant = own_.gas_constant_sum + m * inflator_.gas_constant_sum;
  const double temperature = p * volume_ / gas_constant;
  if (!(temperature >= range_.low && temperature <= range_.high))
    throw DomainError("tank test: at " + to_text(time) + " s the gas in the tank is at " +
                      to_text(temperature) + " K, outside " + to_text(range_.low) + " to " +
                      to_text(range_.high) + " K: pressures, volume and mass do not fit");
  const double cv = own_.cv(temperature) + m * inflator_.cv(temperature);
  return {cv * volume_ * dp / gas_constant, cv * temperature * inflator_.gas_constant_sum / gas_constant -
                                                inflator_.internal_energy(temperature)};
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
    // Outlet flow goes with T^(-1/2): d ln(excess)/d ln T.
    const double slope = std::max(kLeastSlope, inflator_.cp(t) * t / content - 0.5);
    const double step = excess > 0.0 ? std::clamp(-std::log(excess) / slope, -1.0, 1.0) : 1.0;
    const double next = std::clamp(t * std::exp(step), range_.low, range_.high);
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
