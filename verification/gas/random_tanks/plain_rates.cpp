// SPDX-License-Identifier: Apache-2.0
#include "plain_rates.hpp"

#include <algorithm>
#include <numeric>

namespace random_tanks {
namespace {

constexpr double kLaminarShare = 1e-8;            // d / p_a of (G.22)
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

bool PlainRates::locate(double t, std::span<const double> y, PlainState<double>& state) const {
  return find(t, y, state);
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
