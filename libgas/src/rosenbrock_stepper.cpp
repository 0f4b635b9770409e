// SPDX-License-Identifier: Apache-2.0
// Rosenbrock 4(3) with the coefficients of Boost.Odeint, whose own stepper allocates in each step. The
// rates depend on the unknowns y only through the gas, z = S y: the species' masses, and the energy less what
// they bring along at the gas's temperature. So the Jacobian is C S with C = d(rates)/dz by differences, and
// (1/(gamma h) - C S) x = b has the solution x = gamma h (b + C z), (1/(gamma h) - S C) z = S b. In these z
// each part of the gas hastens its own way out, at constant T or p: pivots are positive as they come.
#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>
#include <limits>

#include "near.hpp"
#include "stepper.hpp"

namespace gas {
namespace {

using Vector = Stepper::Vector;

// Change of the gas, relative, for differences: at most.
constexpr double kIncrement = 1e-7;
// Rounding of p, relative: some hundred operations.
constexpr double kNoise = 2e-14;
// Of the step, at most: small against it, yet so large that rounding of x does not show in the slope with x.
constexpr double kStepShare = 1e-3;

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
        gas_(species + 1),
        energy_(species + 1),
        y_(n),
        rate_(n),
        far_(n),
        slope_(n),
        right_(n),
        g_{Vector(n), Vector(n), Vector(n), Vector(n), Vector(n)} {}

  void step(Rates& rates, const Vector& y, const Vector& dydx, double x, double h, bool,
            Trial& out) override {
    fill_matrix(rates, y, dydx, x, h);
    // The sum of gamma_ij that d4 stands for is -0.0362: Odeint (1.74) has it without the sign, which leaves
    // order 1 where the rates depend on time.
    const auto& c = coefficients_;
    stage(rates, y, dydx, x, h, 0, {}, 0.0, {}, c.d1);
    stage(rates, y, dydx, x, h, 1, {c.a21}, c.c2, {c.c21}, c.d2);
    stage(rates, y, dydx, x, h, 2, {c.a31, c.a32}, c.c3, {c.c31, c.c32}, c.d3);
    stage(rates, y, dydx, x, h, 3, {c.a41, c.a42, c.a43}, c.c4, {c.c41, c.c42, c.c43}, -c.d4);
    stage(rates, y, dydx, x, h, 4, {c.a51, c.a52, c.a53, c.a54}, 1.0, {c.c51, c.c52, c.c53, c.c54}, 0.0);
    for (std::size_t i = 0; i < y_.size(); ++i) y_[i] += g_[4][i];
    rates(y_, rate_, x + h);
    right_side(h, {c.c61, c.c62, c.c63, c.c64, c.c65}, 0.0);
    solve(rates.balance, h, out.error);
    for (std::size_t i = 0; i < y_.size(); ++i) out.end[i] = y_[i] + out.error[i];
    rates(out.end, out.end_rate, x + h);
  }
  double error_power() const override { return 4.0; }
  double stability_limit() const override { return std::numeric_limits<double>::infinity(); }

 private:
  /// right_ = rate_ + h d slope_ + sum weights g / h.
  void right_side(double h, std::initializer_list<double> weights, double d) {
    for (std::size_t i = 0; i < right_.size(); ++i) {
      double sum = 0.0;
      const Vector* g = g_.data();
      for (const double weight : weights) sum += weight * (*g++)[i];
      right_[i] = rate_[i] + h * d * slope_[i] + sum / h;
    }
  }

  /// y_ = y + sum shifts g, and the stage's g there.
  void stage(Rates& rates, const Vector& y, const Vector& dydx, double x, double h, std::size_t number,
             std::initializer_list<double> shifts, double node, std::initializer_list<double> weights,
             double d) {
    for (std::size_t i = 0; i < y.size(); ++i) {
      y_[i] = y[i];
      const Vector* g = g_.data();
      for (const double shift : shifts) y_[i] += shift * (*g++)[i];
    }
    if (number == 0)
      rate_ = dydx;
    else
      rates(y_, rate_, x + node * h);
    right_side(h, weights, d);
    solve(rates.balance, h, g_[number]);
  }

  /// `near` = slope, of second order, at the first of three rates `change` apart; far_ is the third.
  void to_slope(const Vector& here, double change, Vector& near) const {
    for (std::size_t i = 0; i < near.size(); ++i)
      near[i] = (4.0 * (near[i] - here[i]) - (far_[i] - here[i])) / (2.0 * change);
  }

  /// Column `part` of C, from a change of that part of the gas: more of what is there, so that no mass turns
  /// negative.
  void difference(Rates& rates, const Vector& dydx, const Vector& y, std::size_t part, double change,
                  double x) {
    const std::size_t work = rates.balance.work_slot();
    const auto change_to = [&](double times, Vector& rate) {
      if (part < work) y_[part] = y[part] - times * change;
      y_[work] = y[work] - times * change * energy_[part];
      rates(y_, rate, x);
    };
    change_to(1.0, columns_[part]);
    change_to(2.0, far_);
    y_[part] = y[part];
    y_[work] = y[work];
    to_slope(dydx, change, columns_[part]);
  }

  /// z = S y of a change of the unknowns.
  void gas_change(const FlowBalance& balance, const Vector& y, Vector& z) const {
    double brought = 0.0;
    for (std::size_t k = 0; k < balance.species(); ++k) {
      z[k] = balance.species_change(y, k);
      brought += energy_[k] * z[k];
    }
    z.back() = balance.energy_change(y) - brought;
  }

  /// x of the matrix for the right side right_.
  void solve(const FlowBalance& balance, double h, Vector& x) {
    gas_change(balance, right_, gas_);
    factors_.solve(gas_);
    for (std::size_t i = 0; i < x.size(); ++i) {
      double sum = right_[i];
      for (std::size_t part = 0; part < gas_.size(); ++part) sum += columns_[part][i] * gas_[part];
      x[i] = coefficients_.gamma * h * sum;
    }
  }

  /// Relative change of the gas at the last point for a difference. Flow is the root of d = |p - p_a|/p: a
  /// second-order difference over r d is off by r^2, and by noise/(r d), which balance at r^3 = noise/d.
  static double increment(const FlowBalance& balance) {
    const double d = std::max(std::abs(balance.pressure_excess()) / balance.point().pressure, kNear);
    return std::min(kIncrement, std::cbrt(kNoise * d * d));
  }

  /// Forward in x by what changes p by increment(), at most kStepShare of the step; exact in x.
  double time_increment(const Rates& rates, double x, double h) const {
    const FlowBalance& balance = rates.balance;
    const double t = rates.time(x), energy = balance.point().pressure * balance.point().volume;
    const double change = increment(balance) * energy / std::abs(balance.closed_pressure_growth(t));
    const double increment = change > 0.0 ? rates.position(t + change) - x : kStepShare * h;
    const double chosen = std::max(std::min(increment, kStepShare * h),
                                   8.0 * std::numeric_limits<double>::epsilon() * std::abs(x));
    return (x + chosen) - x;
  }

  /// columns_, energy_, the factors of 1/(gamma h) - S C, and slope_, the rates' derivative with x.
  void fill_matrix(Rates& rates, const Vector& y, const Vector& dydx, double x, double h) {
    const FlowBalance& balance = rates.balance;
    y_ = y;
    rates.balance.locate(y, rates.time(x));
    const double mass = balance.point().mass, energy = balance.point().thermal_energy;
    const double change = increment(balance);
    for (std::size_t k = 0; k < balance.species(); ++k) energy_[k] = balance.species_energy(k);
    energy_.back() = 1.0;
    const double step = time_increment(rates, x, h);
    rates(y_, slope_, x + step);
    rates(y_, far_, x + 2.0 * step);
    to_slope(dydx, step, slope_);
    for (std::size_t part = 0; part < gas_.size(); ++part) {
      std::ranges::fill(columns_[part], 0.0);  // of no gas: nothing has left yet
      if (mass > 0.0)
        difference(rates, dydx, y, part, change * (part < balance.species() ? mass : energy), x);
      gas_change(balance, columns_[part], gas_);
      for (std::size_t i = 0; i < gas_.size(); ++i)
        factors_.at(i, part) = (i == part ? 1.0 / (coefficients_.gamma * h) : 0.0) - gas_[i];
    }
    factors_.factorize();
  }

  const boost::numeric::odeint::default_rosenbrock_coefficients<double> coefficients_{};
  Factors factors_;
  std::vector<Vector> columns_;  // of C
  Vector gas_;                   // z
  Vector energy_;                // [J/kg] that a change of each mass takes along; 1 for the energy itself
  Vector y_, rate_, far_, slope_, right_;
  std::array<Vector, 5> g_;
};

}  // namespace

std::unique_ptr<Stepper> make_rosenbrock_stepper(const FlowBalance& balance) {
  return std::make_unique<RosenbrockStepper>(balance.unknowns(), balance.species());
}

}  // namespace gas
