// SPDX-License-Identifier: Apache-2.0
#include "gas_at_start.hpp"

#include <fmt/format.h>

#include <cmath>

#include "gas/species.hpp"

namespace driver::imported {
namespace {

constexpr double moment = 1e-9;  // of the run

/// [J/kg] internal energy by the polynomial of cp.
double energy_of(const BagGas& gas, double temperature) {
  double enthalpy = 0.0;
  for (std::size_t j = gas.cp.size(); j-- > 0;)
    enthalpy = (enthalpy + gas.cp[j] / static_cast<double>(j + 1)) * temperature;
  return enthalpy - gas::kMolarGasConstant / gas.molar_mass * temperature;
}

double temperature_of(const BagGas& gas, double energy, double guess) {
  constexpr int most = 50;
  constexpr double rounding = 1e-14;
  for (int i = 0; i < most; ++i) {
    const double step = 1e-3 * guess, excess = energy_of(gas, guess) - energy;
    const double cv = (energy_of(gas, guess + step) - energy_of(gas, guess - step)) / (2.0 * step);
    if (!(cv > 0.0) || !(guess > 0.0)) return std::nan("");
    guess -= excess / cv;
    if (std::abs(excess) <= rounding * std::abs(energy)) break;
  }
  return guess;
}

bool is_same(const BagGas& a, const BagGas& b) {
  return a.built_in.empty() && b.built_in.empty() && a.molar_mass == b.molar_mass && a.cp == b.cp;
}

bool fills(const BagInflator& inflator, const BagDeck& bag) {
  constexpr double rounding = 1e-9;
  return inflator.start == 0.0 && inflator.gas.shares.size() == 1 && bag.initial_gas.shares.size() == 1 &&
         is_same(bag.gases[inflator.gas.shares.front().first],
                 bag.gases[bag.initial_gas.shares.front().first]) &&
         std::abs(mass_of(inflator.mass_flow) / inflator.at_once - 1.0) < rounding;
}

}  // namespace

double moment_of(const BagDeck& bag) {
  return moment * bag.end_time;
}

double mass_of(const Knots& flow) {
  double mass = 0.0;
  for (std::size_t i = 1; i < flow.size(); ++i)
    mass += 0.5 * (flow[i][0] - flow[i - 1][0]) * (flow[i][1] + flow[i - 1][1]);
  return mass;
}

void gas_at_start(BagDeck& bag, double volume, ImportReport& report) {
  std::erase_if(bag.inflators, [&](const BagInflator& inflator) {
    if (inflator.at_once == 0.0) return false;
    const BagGas& gas = bag.gases[bag.initial_gas.shares.front().first];
    const double R = gas::kMolarGasConstant / gas.molar_mass;
    const double T0 = bag.initial_temperature, p0 = bag.initial_pressure.value_or(bag.ambient_pressure),
                 m0 = p0 * volume / (R * T0), m = m0 + inflator.at_once;
    const double inflow = inflator.temperature.front()[1];
    const double T =
        fills(inflator, bag)
            ? temperature_of(
                  gas,
                  (m0 * energy_of(gas, T0) + inflator.at_once * (energy_of(gas, inflow) + R * inflow)) / m,
                  T0)
            : std::nan("");
    if (!(T > 0.0)) {
      report.note(fmt::format("{}: {:.4g} kg that are there at time zero flow in within {:g} of the run",
                              inflator.source, inflator.at_once, moment));
      return false;
    }
    bag.initial_pressure = m * R * T / volume;
    bag.initial_temperature = T;
    report.note(
        fmt::format("{}: its {:.4g} kg are there from the start: gas.initial has {:.6g} Pa and {:.5g} K",
                    inflator.source, inflator.at_once, *bag.initial_pressure, T));
    return true;
  });
}

}  // namespace driver::imported
