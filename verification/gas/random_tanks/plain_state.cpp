// SPDX-License-Identifier: Apache-2.0
// The state of the gas from its unknowns.
#include <algorithm>

#include "plain_rates.hpp"

namespace random_tanks {
namespace {

constexpr double kLowest = 1e-3, kHighest = 1e6;  // [K] between which a temperature is looked for
constexpr int kMostIterations = 200;

/// Root of a rising function of which f and f' are given, by Newton's method inside [low, high].
template <class Function>
double root(const Function& f, double low, double high, double guess) {
  double t = std::clamp(guess, low, high);
  for (int i = 0; i < kMostIterations; ++i) {
    const auto [value, slope] = f(t);
    (value > 0.0 ? high : low) = t;
    double next = t - value / slope;
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    if (std::abs(next - t) <= 4e-16 * t) return next;
    t = next;
  }
  return t;
}

}  // namespace

std::pair<double, double> PlainRates::excess(const Coefficients& a, double gas_constant_sum, double energy,
                                             double t) const {
  const double f = polynomial_enthalpy(a, t, minimum_, maximum_) - gas_constant_sum * t - energy;
  const double slope = polynomial_cp(a, std::clamp(t, minimum_, maximum_)) - gas_constant_sum;
  if (tank_.volume_of_overpressure.empty()) return {f, slope};
  Dual product(gas_constant_sum * t);
  product.slope[0] = gas_constant_sum;
  const Dual work = place_on(tank_.volume_of_overpressure, tank_.ambient_pressure, product).work;
  return {f + work.value, slope + work.slope[0]};
}

/// The lowest temperature at which the gas holds `energy` or more; 0: none.
double PlainRates::solve(const Coefficients& lower, const Coefficients& upper, double gas_constant_sum,
                         double energy) const {
  const auto below = [&](double t) { return excess(lower, gas_constant_sum, energy, t); };
  const auto above = [&](double t) { return excess(upper, gas_constant_sum, energy, t); };
  if (below(kLowest).first > 0.0) return 0.0;
  const bool has_joint = maximum_ < HUGE_VAL;
  if (!has_joint) return root(below, kLowest, kHighest, guess_);
  if (below(kJoint).first >= 0.0) return root(below, kLowest, kJoint, guess_);
  if (above(kJoint).first >= 0.0) return kJoint;
  return root(above, kJoint, kHighest, guess_);
}

template <class Real>
bool PlainRates::find(double t, std::span<const Real> y, PlainState<Real>& state) const {
  const std::size_t n = species_.size();
  std::array<double, kMostUnknowns> masses{};
  state.mass = state.gas_constant_sum = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    masses[k] = value_of(y[k]);
    state.mass += y[k];
    state.gas_constant_sum += species_[k].gas_constant * y[k];
  }
  if (!(value_of(state.mass) > 0.0 && value_of(state.gas_constant_sum) > 0.0)) {
    if (std::ranges::any_of(masses, [](double m) { return m != 0.0; })) return false;
    state.mass = state.gas_constant_sum = state.cp_sum = 0.0;
    state.temperature = tank_.temperature;
    state.place = {0.0, -tank_.ambient_pressure, 1.0, 0.0};
    return true;
  }
  const double r = value_of(state.gas_constant_sum), energy = value_of(y[n]);
  const double temperature = solve(sum(false, masses), sum(true, masses), r, energy);
  if (!(temperature > 0.0)) return false;
  guess_ = temperature;
  const bool upper = temperature > kJoint, follows = !tank_.volume_of_overpressure.empty();
  // One Newton step from the root with derivatives: those of the implicit function.
  Real excess = -y[n] - state.gas_constant_sum * temperature;
  state.cp_sum = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    const Coefficients& a = upper ? species_[k].upper : species_[k].lower;
    excess += polynomial_enthalpy(a, temperature, minimum_, maximum_) * y[k];
    state.cp_sum += polynomial_cp(a, std::clamp(temperature, minimum_, maximum_)) * y[k];
  }
  double capacity = value_of(state.cp_sum) - r;
  state.temperature = temperature;
  if constexpr (std::is_same_v<Real, Dual>) {
    if (follows) {
      Dual product(r * temperature);
      product.slope[0] = r;
      capacity += place_on(tank_.volume_of_overpressure, tank_.ambient_pressure, product).work.slope[0];
      const Dual fixed = state.gas_constant_sum * temperature;
      excess += place_on(tank_.volume_of_overpressure, tank_.ambient_pressure, fixed).work;
    }
    if (temperature != kJoint) state.temperature = excess.mapped(temperature, -1.0 / capacity);
    Dual cp_of_t = state.cp_sum;
    const double step = 1e-4 * temperature;
    double up = 0.0;
    for (std::size_t k = 0; k < n; ++k)
      up += polynomial_cp(upper ? species_[k].upper : species_[k].lower,
                          std::clamp(temperature + step, minimum_, maximum_)) *
            masses[k];
    for (std::size_t i = 0; i < kMostUnknowns; ++i)
      cp_of_t.slope[i] += (up - cp_of_t.value) / step * state.temperature.slope[i];
    state.cp_sum = cp_of_t;
  }
  const Real product = state.gas_constant_sum * state.temperature;
  if (follows) {
    state.place = place_on(tank_.volume_of_overpressure, tank_.ambient_pressure, product);
    return true;
  }
  const double x = (stretch.since + t) / stretch.length;
  const double volume = stretch.volume.at(t) + 4.0 * stretch.bulge * x * (1.0 - x);
  const Real p = product / volume;
  state.place = {p, p - tank_.ambient_pressure, volume, 0.0};
  return true;
}

template bool PlainRates::find(double, std::span<const double>, PlainState<double>&) const;
template bool PlainRates::find(double, std::span<const Dual>, PlainState<Dual>&) const;

bool PlainRates::locate(double t, std::span<const double> y, PlainState<double>& state) const {
  return find(t, y, state);
}

std::vector<double> PlainRates::levels(double t, std::span<const double> y) const {
  const std::size_t n = species_.size();
  std::vector<double> result(knots_.size() + 5, 0.0);
  PlainState<double> gas;
  if (!find(t, y, gas) || !(gas.mass > 0.0)) return result;
  const double p = gas.place.pressure, dp = gas.place.overpressure, p_a = tank_.ambient_pressure;
  for (std::size_t i = 0; i < knots_.size(); ++i) result[i] = (dp - knots_[i]) / (p_a + std::abs(knots_[i]));
  double* rest = &result[knots_.size()];
  const auto critical = [](double gamma) { return std::pow(2.0 / (gamma + 1.0), gamma / (gamma - 1.0)); };
  rest[0] = p_a > 0.0 ? dp / p_a : 0.0;
  rest[1] = critical(gas.cp_sum / (gas.cp_sum - gas.gas_constant_sum)) - p_a / p;
  rest[2] = p_a > 0.0 ? p / p_a - critical(ambient_gamma_) : 0.0;
  if (maximum_ == HUGE_VAL) return result;
  const double size = gas.cp_sum * kJoint;
  rest[3] = excess(sum(false, y.first(n)), gas.gas_constant_sum, y[n], kJoint).first / size;
  rest[4] = excess(sum(true, y.first(n)), gas.gas_constant_sum, y[n], kJoint).first / size;
  return result;
}

void PlainRates::sizes(double t, std::span<const double> y, std::span<double> size) const {
  PlainState<double> gas;
  const bool found = find(t, y, gas) && gas.mass > 0.0;
  std::ranges::fill(size, found ? gas.mass : 1.0);
  size.back() = found ? (gas.cp_sum - gas.gas_constant_sum) * gas.temperature : 1.0;
}

std::vector<double> PlainRates::start(double perturbation) const {
  const std::size_t n = species_.size();
  std::vector<double> y(n + 1, 0.0);
  double r = 0.0;
  for (std::size_t k = 0; k < n; ++k) r += tank_.start[k] * species_[k].gas_constant;
  const double t = tank_.temperature;
  const double mass = tank_.pressure * tank_.volumes.front() / (r * t);
  for (std::size_t k = 0; k < n; ++k) y[k] = mass * tank_.start[k];
  y[n] = enthalpy(std::span(y).first(n), t) - mass * r * t;
  if (!tank_.volume_of_overpressure.empty())
    y[n] += place_on(tank_.volume_of_overpressure, tank_.ambient_pressure, mass * r * t).work;
  for (std::size_t k = 0; k < n; ++k) y[k] *= 1.0 + perturbation;
  y[n] += perturbation * (std::abs(y[n]) + mass * r * t);
  return y;
}

}  // namespace random_tanks
