// SPDX-License-Identifier: Apache-2.0
#include "inversion.hpp"

#include <algorithm>
#include <cmath>
#include <elementary/exponential.hpp>

#include "require.hpp"

namespace gas {
namespace {

// The area is nearly proportional to the square root of the mass, so each iteration reduces the error by a
// factor of 5 or more.
constexpr int kMostIterations = 100;
constexpr double kSettled = 1e-11;
constexpr double kChoked = 2.1;  // p_c/p above which every gas (gamma up to 5/3) is sonic in the outlet

}  // namespace

std::vector<double> masses_of_rise(const TankTest& test, const Pressures& pressures) {
  std::vector<double> mass(pressures.tank.size(), test.total_mass);
  const auto peak = std::ranges::max_element(pressures.tank);
  for (auto p = pressures.tank.begin(); p < peak; ++p)
    mass[static_cast<std::size_t>(p - pressures.tank.begin())] =
        test.total_mass * std::clamp((*p - pressures.initial) / (*peak - pressures.initial), 0.0, 1.0);
  return mass;
}

void set_adiabatic_rate(const TankTest& test, std::span<const double> masses, Pressures& pressures) {
  const TankGas gas(test, pressures.initial, pressures.conductance);
  pressures.adiabatic_rate = pressures.rate;
  for (std::size_t i = 0; i < masses.size(); ++i)
    pressures.adiabatic_rate[i] = gas.adiabatic_rate(pressures.tank[i], pressures.rate[i], masses[i]);
}

HeldSpread held_spread(const Burn& burn, std::span<const double> temperature) {
  std::vector<double> firm;
  for (std::size_t i = 0; i < temperature.size(); ++i)
    if (burn.firm[i]) firm.push_back(elementary::log(temperature[i]));
  const auto from = [&](double end) {
    double sum = 0.0;
    for (const double t : firm) sum += (t - end) * (t - end);
    return std::min(0.5, std::sqrt(sum / static_cast<double>(firm.size())));
  };
  if (firm.empty()) return {};
  return {from(firm.front()), from(firm.back())};
}

Inversion::Inversion(const TankTest& test, std::span<const double> times, const Pressures& pressures)
    : test_(test),
      times_(times),
      pressures_(pressures),
      gas_(test, pressures.initial, pressures.conductance) {}

std::vector<double> Inversion::enthalpy_flow(double temperature) const {
  std::vector<double> k;
  for (const double dp : pressures_.adiabatic_rate)
    k.push_back(test_.volume * dp / gas_.gamma_r(temperature));
  return k;
}

/// Mass delivered up to each point: the integral of the piecewise linear flow.
std::vector<double> Inversion::masses(const std::vector<double>& mass_flow) const {
  std::vector<double> mass(mass_flow.size(), 0.0);
  for (std::size_t i = 1; i < mass.size(); ++i)
    mass[i] = mass[i - 1] + 0.5 * (mass_flow[i] + mass_flow[i - 1]) * (times_[i] - times_[i - 1]);
  return mass;
}

/// Heat lost up to each point, by trapezoids.
std::vector<double> Inversion::heat_lost(const std::vector<double>& mass) const {
  std::vector<double> lost(mass.size(), 0.0);
  for (std::size_t i = 1; i < lost.size(); ++i)
    lost[i] = lost[i - 1] +
              0.5 * (times_[i] - times_[i - 1]) *
                  (gas_.heat(pressures_.tank[i - 1], mass[i - 1]) + gas_.heat(pressures_.tank[i], mass[i]));
  return lost;
}

TankGas::Rate Inversion::rate(std::size_t i, double mass) const {
  return gas_.rate(times_[i], pressures_.tank[i], pressures_.rate[i], mass);
}

/// Makes the flow zero outside the burn and nowhere negative, and scales it to the known mass.
void Inversion::scale_to_mass(const Burn& burn, std::vector<double>& mass_flow) const {
  for (std::size_t i = 0; i < mass_flow.size(); ++i)
    mass_flow[i] = i >= burn.first && i <= burn.last ? std::max(0.0, mass_flow[i]) : 0.0;
  const double ratio = test_.total_mass / masses(mass_flow).back();
  if (!(ratio > 0.0 && std::isfinite(ratio)))
    throw DomainError("tank test: the tank pressure does not rise, so there is no mass flow");
  for (double& flow : mass_flow) flow *= ratio;
}

FlowCurves Inversion::average_temperature(const Burn& burn) const {
  rate(burn.end, test_.total_mass);  // throws if it is out of range
  // Without heat loss one pass suffices. The loss follows from the masses and changes them little.
  std::vector<double> mass = masses_of_rise(test_, pressures_);
  double enthalpy = 0.0;
  for (int pass = 0; pass < kMostIterations; ++pass) {
    const std::vector<double> lost = heat_lost(mass);
    const double before = enthalpy;
    enthalpy = gas_.mean_enthalpy(pressures_.tank[burn.end], test_.total_mass, lost[burn.end]);
    for (std::size_t i = 0; i < mass.size(); ++i)
      mass[i] = i < burn.first  ? 0.0
                : i > burn.last ? test_.total_mass
                                : gas_.delivered(pressures_.tank[i], enthalpy, lost[i], test_.total_mass,
                                                 i == 0 ? 0.0 : mass[i - 1]);
    if (pressures_.conductance == 0.0 || std::abs(enthalpy - before) <= kSettled * std::abs(enthalpy)) break;
  }
  const double temperature = gas_.inflow_temperature(enthalpy);
  FlowCurves flow{std::vector<double>(times_.size(), 0.0), std::vector<double>(times_.size(), temperature),
                  temperature};
  for (std::size_t i = burn.first; i <= burn.last; ++i)
    flow.mass_flow[i] = gas_.mass_flow(rate(i, mass[i]), temperature);
  scale_to_mass(burn, flow.mass_flow);
  return flow;
}

/// Gives points that are not firm the temperature of the nearest firm point.
std::vector<double> Inversion::held(const Burn& burn, std::vector<double> temperature) const {
  std::ptrdiff_t before = -1;
  for (std::ptrdiff_t i = 0; i < std::ssize(temperature); ++i) {
    const auto at = temperature.begin() + i;
    if (!burn.firm[static_cast<std::size_t>(i)]) {
      if (before >= 0) *at = temperature[static_cast<std::size_t>(before)];
      continue;
    }
    std::fill(before < 0 ? temperature.begin() : temperature.begin() + (before + i) / 2 + 1, at, *at);
    if (before < 0)
      for (auto t = temperature.begin(); t < at; ++t) *t *= burn.before;
    before = i;
  }
  for (auto t = temperature.begin() + before + 1; before >= 0 && t < temperature.end(); ++t) *t *= burn.after;
  return temperature;
}

/// Temperature and flow at every point, for the area of `flow` and the mass in the tank at that point. At
/// masked points a choked outlet gives the flow better than K.
void Inversion::solve(const Burn& burn, const std::vector<double>& mass, FlowCurves& flow) const {
  std::vector<double> solved = flow.temperature;
  for (std::size_t i = 0; i <= burn.end; ++i)
    if (!burn.masked[i])
      solved[i] = gas_.stagnation_temperature(rate(i, mass[i]), flow.effective_area, pressures_.chamber[i],
                                              pressures_.tank[i], solved[i]);
  flow.temperature = held(burn, solved);
  for (std::size_t i = 0; i <= burn.end; ++i) {
    const double chamber = pressures_.chamber[i], tank = pressures_.tank[i];
    if (!burn.masked[i] && solved[i] > gas_.temperatures().low) flow.temperature[i] = solved[i];
    flow.mass_flow[i] = burn.masked[i] && !burn.clipped[i] && chamber > kChoked * tank
                            ? gas_.outlet_flow(flow.effective_area, flow.temperature[i], chamber, tank)
                            : gas_.mass_flow(rate(i, mass[i]), flow.temperature[i]);
  }
}

/// The area that gives the total mass at the mean temperature.
double Inversion::guessed_area(double temperature) const {
  double mass = 0.0;
  for (std::size_t i = 1; i < times_.size(); ++i)
    mass += gas_.outlet_flow(1.0, temperature, pressures_.chamber[i], pressures_.tank[i]) *
            (times_[i] - times_[i - 1]);
  if (!(mass > 0.0)) throw DomainError("tank test: the chamber pressure is never above the tank's");
  return test_.total_mass / mass;
}

FlowCurves Inversion::dual_pressure(const Burn& burn, const FlowCurves& guess) const {
  FlowCurves flow = guess;
  if (!(flow.effective_area > 0.0)) flow.effective_area = guessed_area(guess.mean_temperature);
  std::vector<double> mass = masses(flow.mass_flow);
  for (int i = 0; i < kMostIterations; ++i) {
    solve(burn, mass, flow);
    std::vector<double> next = masses(flow.mass_flow);
    const double ratio = test_.total_mass / next[burn.end];
    if (!(ratio > 0.0 && std::isfinite(ratio)))
      throw DomainError(
          "tank test: no area of the outlet gives the mass: pressures, volume and mass do not fit");
    double change = std::abs(ratio - 1.0);
    for (std::size_t j = 0; j < mass.size(); ++j) {
      // The mass so far is a share of the total, so that no step leaves the range of temperatures.
      next[j] = std::clamp(ratio * next[j], 0.0, test_.total_mass);
      change = std::max(change, std::abs(next[j] - mass[j]) / test_.total_mass);
    }
    if (change < kSettled) {
      scale_to_mass(burn, flow.mass_flow);
      return flow;
    }
    mass = next;
    flow.effective_area *= std::sqrt(ratio);  // T_s ~ A^-2, so mdot ~ A^2
  }
  throw DomainError("tank test: the iteration for the outlet's area does not settle");
}

}  // namespace gas
