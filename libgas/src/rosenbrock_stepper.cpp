// SPDX-License-Identifier: Apache-2.0
// Rosenbrock 4(3) with the coefficients of Boost.Odeint, whose own stepper allocates in each step. The
// rates of the unknowns y depend on the gas alone, so it is stepped beside them: w' = in(t) + S r(w, t), y' =
// r. Inflow counts as a rate of the gas here: where it leaves as it comes, through a volume that holds far
// less than passes in a step, the gas hardly changes, and each stage sees just that. The matrix is solved in
// z, which is w with the energy less what the masses bring along at the gas's temperature: there each part of
// the gas hastens its own way out, at constant T or p, and pivots are positive as they come.
#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>
#include <limits>

#include "near.hpp"
#include "stepper.hpp"

namespace gas {
namespace {

using Vector = Stepper::Vector;

// Change of the gas at constant p, and of p - p_a, relative, for differences of second order, which rounding,
// 1e-15/1e-5, and truncation, 1e-10, then leave alike; where the temperature range is narrow, less.
constexpr double kIncrement = 1e-5, kSmallIncrement = 1e-7;
// Of the step, at most: small against it, for a difference of second order, yet so large that the flows'
// rounding over it is still small against what flows in the step.
constexpr double kStepShare = 1.0 / 64.0;

/// Dense LU factors in place, without pivoting: a row that is zero but for its diagonal, that of an absent
/// species, stays so to the bit, and no mass of it appears.
class Factors {
 public:
  explicit Factors(std::size_t n) : n_(n), a_(n * n) {}
  double& at(std::size_t i, std::size_t j) { return a_[i * n_ + j]; }

  void factorize() {
    for (std::size_t k = 0; k < n_; ++k)
      for (std::size_t i = k + 1; i < n_; ++i) {
        const double factor = at(i, k) /= at(k, k);
        for (std::size_t j = k + 1; j < n_; ++j) at(i, j) -= factor * at(k, j);
      }
  }

  void solve(Vector& b) {
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j < i; ++j) b[i] -= at(i, j) * b[j];
    for (std::size_t i = n_; i-- > 0;) {
      for (std::size_t j = i + 1; j < n_; ++j) b[i] -= at(i, j) * b[j];
      b[i] /= at(i, i);
    }
  }

 private:
  std::size_t n_;
  std::vector<double> a_;
};

class RosenbrockStepper : public Stepper {
 public:
  RosenbrockStepper(std::size_t n, std::size_t species)
      : factors_(species + 1),
        columns_(species + 1, Vector(n)),
        energy_(species + 1),
        by_pressure_(n),
        far_(n) {
    for (Gas* gas : {&gas_, &trial_gas_, &column_}) gas->resize(species + 1);
    for (Pair* pair : {&rate_, &slope_, &right_}) *pair = {Vector(n), Gas(species + 1)};
    g_.fill(rate_);
  }

  void step(Rates& rates, const Vector& y, const Vector&, double x, double h, bool, Trial& out) override {
    rates.balance.gas_begin(gas_);
    evaluate(rates, {}, x);  // at the very point of the matrix: of p - p_a the last step's end may know less
    fill_matrix(rates, x, h);
    // The sum of gamma_ij that d4 stands for is -0.0362: Odeint (1.74) has it without the sign, which leaves
    // order 1 where the rates depend on time.
    const auto& c = coefficients_;
    solve_stage(h, {}, c.d1, g_[0]);
    const auto stage = [&](std::size_t number, std::initializer_list<double> shifts, double node,
                           std::initializer_list<double> weights, double d) {
      evaluate(rates, shifts, x + node * h);
      solve_stage(h, weights, d, g_[number]);
    };
    stage(1, {c.a21}, c.c2, {c.c21}, c.d2);
    stage(2, {c.a31, c.a32}, c.c3, {c.c31, c.c32}, c.d3);
    stage(3, {c.a41, c.a42, c.a43}, c.c4, {c.c41, c.c42, c.c43}, -c.d4);
    stage(4, {c.a51, c.a52, c.a53, c.a54}, 1.0, {c.c51, c.c52, c.c53, c.c54}, 0.0);
    stage(5, {c.a51, c.a52, c.a53, c.a54, 1.0}, 1.0, {c.c61, c.c62, c.c63, c.c64, c.c65}, 0.0);
    out.error = g_[5].flows;
    for (std::size_t i = 0; i < y.size(); ++i)
      out.end[i] = y[i] + sum(&Pair::flows, i, {c.a51, c.a52, c.a53, c.a54, 1.0, 1.0});
    // What holds p ends its sub-step where it turns; stopped, it would not be seen to.
    out.reversed = rates.balance.is_held() ? 0.0 : rates.balance.stop_reversed_streams(out.end, out.error);
    rates.balance.close_streams(out.end);
    rates(out.end, out.end_rate, x + h);
  }
  double error_power() const override { return 4.0; }
  double stability_limit() const override { return gas::stability_limit(Method::kRosenbrock4); }

 private:
  using Gas = FlowBalance::Gas;
  /// Changes of the unknowns, and of the gas.
  struct Pair {
    Vector flows;
    Gas gas;
  };

  /// sum weights g, at place i of one part.
  double sum(Vector Pair::*part, std::size_t i, std::initializer_list<double> weights) const {
    double result = 0.0;
    const Pair* g = g_.data();
    for (const double weight : weights) result += weight * ((g++)->*part)[i];
    return result;
  }

  /// rate_ at the gas of the begin + sum shifts g.
  void evaluate(Rates& rates, std::initializer_list<double> shifts, double x) {
    for (std::size_t i = 0; i < gas_.size(); ++i) trial_gas_[i] = gas_[i] + sum(&Pair::gas, i, shifts);
    rates.of_gas(trial_gas_, rate_.flows, x);
    rates.gas_rates(rate_.flows, rate_.gas, x);
  }

  /// The g of the right side rate_ + h d slope_ + sum weights g / h.
  void solve_stage(double h, std::initializer_list<double> weights, double d, Pair& g) {
    for (const auto part : {&Pair::flows, &Pair::gas})
      for (std::size_t i = 0; i < (right_.*part).size(); ++i)
        (right_.*part)[i] = (rate_.*part)[i] + h * d * (slope_.*part)[i] + sum(part, i, weights) / h;
    g.gas = right_.gas;
    to_parts(g.gas);
    factors_.solve(g.gas);
    for (std::size_t i = 0; i < g.flows.size(); ++i) {
      double rate = right_.flows[i];
      for (std::size_t part = 0; part < g.gas.size(); ++part) rate += columns_[part][i] * g.gas[part];
      g.flows[i] = coefficients_.gamma * h * rate;
    }
    for (std::size_t k = 0; k + 1 < g.gas.size(); ++k) g.gas.back() += energy_[k] * g.gas[k];
  }

  /// w to z.
  void to_parts(Gas& change) const {
    for (std::size_t k = 0; k + 1 < change.size(); ++k) change.back() -= energy_[k] * change[k];
  }

  /// `near` = slope, of second order, at the first of three rates `change` apart.
  static void to_slope(const Vector& here, double change, const Vector& far, Vector& near) {
    for (std::size_t i = 0; i < near.size(); ++i)
      near[i] = (4.0 * (near[i] - here[i]) - (far[i] - here[i])) / (2.0 * change);
  }

  /// by_pressure_ at `here`. Flow is the root of p - p_a, which may be far less than p knows: the derivative
  /// with p is one number a rate, and p's with the gas is exact.
  void fill_pressure_slope(Rates& rates, const FlowBalance::Point& here, double x) {
    const FlowBalance& balance = rates.balance;
    const double least = kNear * here.pressure / here.compliance;
    const double apart = std::copysign(std::max(std::abs(here.overpressure), least), here.overpressure);
    const double change = kIncrement * (balance.is_held() ? here.pressure : apart);
    rates.of_gas(gas_, by_pressure_, x, here, change);
    rates.of_gas(gas_, far_, x, here, 2.0 * change);
    to_slope(rate_.flows, change, far_, by_pressure_);
    by_pressure_[balance.heat_slot()] = 0.0;  // at constant T; the difference would be its rounding
    by_pressure_[balance.work_slot()] = balance.volume_rate(rates.time(x)) * rates.time_slope(x);
  }

  /// Column `part` of d(rates)/dz, (G.23).
  void difference(Rates& rates, const FlowBalance::Point& here, std::size_t part, double change, double x) {
    const auto change_to = [&](double times, Vector& rate) {
      trial_gas_ = gas_;
      if (part + 1 < gas_.size()) trial_gas_[part] += times * change;
      trial_gas_.back() += times * change * energy_[part];
      rates.of_gas(trial_gas_, rate, x, here, 0.0);
    };
    change_to(1.0, columns_[part]);
    change_to(2.0, far_);
    to_slope(rate_.flows, change, far_, columns_[part]);
    const double slope = rates.balance.pressure_slope(here, part);
    for (std::size_t i = 0; i < by_pressure_.size(); ++i) columns_[part][i] += slope * by_pressure_[i];
  }

  /// The rates' derivative with x, the gas held.
  void fill_slope(Rates& rates, const FlowBalance::Point& here, double x, double h) {
    const double least = 8.0 * std::numeric_limits<double>::epsilon() * std::abs(x);
    const double step = (x + std::max(least, kStepShare * h)) - x;  // exact in x
    rates.of_gas(gas_, slope_.flows, x + step, here, 0.0);
    rates.of_gas(gas_, far_, x + 2.0 * step, here, 0.0);
    to_slope(rate_.flows, step, far_, slope_.flows);
    const double slope =
        -here.pressure * rates.balance.volume_rate(rates.time(x)) / here.volume * rates.time_slope(x);
    for (std::size_t i = 0; i < by_pressure_.size(); ++i) slope_.flows[i] += slope * by_pressure_[i];
    rates.gas_slope(slope_.flows, slope_.gas, x);
  }

  /// columns_, energy_, the factors of 1/(gamma h) - S d(rates)/dz, and slope_. Differences are to more of
  /// what is there, so that no mass turns negative, and to less energy at the upper end of the temperature
  /// range.
  void fill_matrix(Rates& rates, double x, double h) {
    const FlowBalance& balance = rates.balance;
    const FlowBalance::Point here = balance.point();
    const auto beyond = [&](double share) {
      const double change = here.temperature * share, top = balance.thermo().maximum_temperature();
      return here.temperature + change > top ||
             here.temperature - change < balance.thermo().minimum_temperature();
    };
    const double change = beyond(3.0 * kIncrement) ? kSmallIncrement : kIncrement;
    const bool at_top = here.temperature * (1.0 + 3.0 * change) > balance.thermo().maximum_temperature();
    const double inward = at_top ? -here.thermal_energy : here.thermal_energy;
    for (std::size_t k = 0; k < balance.species(); ++k) energy_[k] = balance.species_energy(k);
    energy_.back() = 1.0;
    if (here.mass > 0.0) fill_pressure_slope(rates, here, x);
    fill_slope(rates, here, x, h);
    for (std::size_t part = 0; part < gas_.size(); ++part) {
      std::ranges::fill(columns_[part], 0.0);  // of no gas: nothing has left yet
      if (here.mass > 0.0)
        difference(rates, here, part, change * (part < balance.species() ? here.mass : inward), x);
      balance.gas_change(columns_[part], column_);
      to_parts(column_);
      for (std::size_t i = 0; i < gas_.size(); ++i)
        factors_.at(i, part) = (i == part ? 1.0 / (coefficients_.gamma * h) : 0.0) - column_[i];
    }
    factors_.factorize();
  }

  const boost::numeric::odeint::default_rosenbrock_coefficients<double> coefficients_{};
  Factors factors_;
  std::vector<Vector> columns_;  // of d(rates)/dz
  Vector energy_;                // [J/kg] that a change of each mass takes along; 1 for the energy itself
  Vector by_pressure_;           // d(rates)/dp, the gas held
  Gas gas_, trial_gas_, column_;
  Vector far_;
  Pair rate_, slope_, right_;
  std::array<Pair, 6> g_;
};

}  // namespace

std::unique_ptr<Stepper> make_rosenbrock_stepper(const FlowBalance& balance) {
  return std::make_unique<RosenbrockStepper>(balance.unknowns(), balance.species());
}

}  // namespace gas
