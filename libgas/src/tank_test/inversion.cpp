// SPDX-License-Identifier: Apache-2.0
#include "inversion.hpp"

#include <algorithm>
#include <cmath>

#include "require.hpp"

namespace gas {
namespace {

// The share of the inflator's gas that (G.33) depends on converges by a factor of 5 or more an iteration.
constexpr int kMostIterations = 100;
constexpr double kSettled = 1e-11;

}  // namespace

Inversion::Inversion(const TankTest& test, std::span<const double> times, const Pressures& pressures)
    : test_(test), times_(times), pressures_(pressures), gas_(test, pressures.tank.front()) {}

std::vector<double> Inversion::enthalpy_flow(double temperature) const {
  std::vector<double> k;
  for (const double dp : pressures_.rate) k.push_back(test_.volume * dp / gas_.gamma_r(temperature));
  return k;
}

/// Mass delivered up to each point: the integral of the piecewise linear flow.
std::vector<double> Inversion::masses(const std::vector<double>& mass_flow) const {
  std::vector<double> mass(mass_flow.size(), 0.0);
  for (std::size_t i = 1; i < mass.size(); ++i)
    mass[i] = mass[i - 1] + 0.5 * (mass_flow[i] + mass_flow[i - 1]) * (times_[i] - times_[i - 1]);
  return mass;
}

TankGas::Rate Inversion::rate(std::size_t i, double mass) const {
  return gas_.rate(times_[i], pressures_.tank[i], pressures_.rate[i], mass);
}

/// Flow from (G.33) at the temperatures of `flow`, and the masses that follow. True once both repeat;
/// `ratio` is the known total mass over this one.
bool Inversion::settle(const Burn& burn, std::vector<double>& mass, Flow& flow, double& ratio) const {
  for (std::size_t i = burn.first; i <= burn.last; ++i)
    flow.mass_flow[i] = std::max(0.0, gas_.mass_flow(rate(i, mass[i]), flow.temperature[i]));
  const std::vector<double> next = masses(flow.mass_flow);
  double change = 0.0;
  for (std::size_t i = 0; i < mass.size(); ++i) change = std::max(change, std::abs(next[i] - mass[i]));
  mass = next;
  ratio = test_.total_mass / mass.back();
  if (!(ratio > 0.0 && std::isfinite(ratio)))
    throw DomainError("tank test: the tank pressure does not rise: no mass flow follows from it");
  return std::max(std::abs(ratio - 1.0), change / test_.total_mass) < kSettled;
}

Flow Inversion::average_temperature(const Burn& burn) const {
  Flow flow{std::vector<double>(times_.size(), 0.0), std::vector<double>(times_.size()),
            test_.initial_temperature};
  std::vector<double> mass(times_.size(), 0.0);
  double ratio = 1.0;
  for (int i = 0; i < kMostIterations; ++i) {
    std::ranges::fill(flow.temperature, flow.mean_temperature);
    if (settle(burn, mass, flow, ratio)) return flow;
    flow.mean_temperature /= ratio;
    const auto [low, high] = gas_.temperatures();
    if (!(flow.mean_temperature >= low && flow.mean_temperature <= high))
      throw DomainError("tank test: the mean temperature " + to_text(flow.mean_temperature) +
                        " K is outside " + to_text(low) + " to " + to_text(high) +
                        " K: pressures, volume and mass do not fit");
  }
  throw DomainError("tank test: the iteration for the mean temperature does not settle");
}

/// (G.36) at every point that is not masked; low end of the range where K <= 0 (only in a draw).
std::vector<double> Inversion::solved_temperatures(const Burn& burn, const std::vector<double>& mass,
                                                   const Flow& flow) const {
  std::vector<double> solved = flow.temperature;
  for (std::size_t i = burn.first; i <= burn.last; ++i)
    if (!burn.masked[i])
      solved[i] = gas_.stagnation_temperature(rate(i, mass[i]), flow.effective_area, pressures_.chamber[i],
                                              pressures_.tank[i], flow.temperature[i]);
  return solved;
}

/// Where masked or without solution: the temperature of the nearest point that has one, if any.
std::vector<double> Inversion::held(const Burn& burn, std::vector<double> temperature) const {
  std::ptrdiff_t before = -1;
  for (std::ptrdiff_t i = 0; i < std::ssize(temperature); ++i) {
    const auto at = temperature.begin() + i;
    if (unresolved(burn, *at, static_cast<std::size_t>(i))) {
      if (before >= 0) *at = temperature[static_cast<std::size_t>(before)];
      continue;
    }
    std::fill(before < 0 ? temperature.begin() : temperature.begin() + (before + i) / 2 + 1, at, *at);
    before = i;
  }
  return temperature;
}

bool Inversion::unresolved(const Burn& burn, double temperature, std::size_t i) const {
  return burn.masked[i] || temperature == gas_.temperatures().low;
}

Flow Inversion::dual_pressure(const Burn& burn, const Flow& guess) const {
  Flow flow = guess;
  std::vector<double> mass = masses(flow.mass_flow), solved;
  double ratio = 1.0;
  bool settled = false;
  for (int i = 0; i < kMostIterations && !settled; ++i) {
    flow.effective_area *= std::sqrt(ratio);  // T_s ~ A^-2, so mdot ~ A^2
    solved = solved_temperatures(burn, mass, flow);
    flow.temperature = held(burn, solved);
    settled = settle(burn, mass, flow, ratio);
  }
  if (!settled) throw DomainError("tank test: the iteration for the outlet's area does not settle");
  // The integral has taken a held temperature there; the point itself goes to T_s -> 0, mdot -> infinity.
  for (std::size_t i = burn.first; i <= burn.last; ++i)
    if (!burn.masked[i] && unresolved(burn, solved[i], i)) {
      flow.temperature[i] = solved[i];
      flow.mass_flow[i] =
          gas_.outlet_flow(flow.effective_area, solved[i], pressures_.chamber[i], pressures_.tank[i]);
    }
  return flow;
}

}  // namespace gas
