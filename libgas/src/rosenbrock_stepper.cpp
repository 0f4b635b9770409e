// SPDX-License-Identifier: Apache-2.0
// Rosenbrock 4(3) with the coefficients of Boost.Odeint, whose own stepper allocates in each step. The
// Jacobian is by differences: the rates depend on the unknowns only through the species' masses and the
// energy, so species + 1 of them fill it.
#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>
#include <limits>
#include <numeric>

#include "stepper.hpp"

namespace gas {
namespace {

using Vector = Stepper::Vector;

// Balances truncation (its square) and rounding of a second-order difference where p - p_a is 1e-4 to 1e-2 of
// p.
constexpr double kIncrement = 1e-7;
// Of the step, at most: small against it, yet so large that rounding of x does not show in the slope with x.
constexpr double kStepShare = 1e-3;

/// Dense LU factors with row pivoting, in place.
class Factors {
 public:
  explicit Factors(std::size_t n) : n_(n), a_(n * n), row_(n) {}
  double& at(std::size_t i, std::size_t j) { return a_[i * n_ + j]; }

  void factorize() {
    std::iota(row_.begin(), row_.end(), std::size_t{0});
    for (std::size_t k = 0; k < n_; ++k) {
      std::size_t pivot = k;
      for (std::size_t i = k + 1; i < n_; ++i)
        if (std::abs(at(i, k)) > std::abs(at(pivot, k))) pivot = i;
      if (pivot != k) {
        std::swap(row_[k], row_[pivot]);
        std::swap_ranges(&at(k, 0), &at(k, 0) + n_, &at(pivot, 0));
      }
      for (std::size_t i = k + 1; i < n_; ++i) {
        const double factor = at(i, k) /= at(k, k);
        if (factor == 0.0) continue;
        for (std::size_t j = k + 1; j < n_; ++j) at(i, j) -= factor * at(k, j);
      }
    }
  }

  void solve(const Vector& b, Vector& x) {
    for (std::size_t i = 0; i < n_; ++i) {
      x[i] = b[row_[i]];
      for (std::size_t j = 0; j < i; ++j) x[i] -= at(i, j) * x[j];
    }
    for (std::size_t i = n_; i-- > 0;) {
      for (std::size_t j = i + 1; j < n_; ++j) x[i] -= at(i, j) * x[j];
      x[i] /= at(i, i);
    }
  }

 private:
  std::size_t n_;
  std::vector<double> a_;
  std::vector<std::size_t> row_;
};

class RosenbrockStepper : public Stepper {
 public:
  explicit RosenbrockStepper(std::size_t n)
      : factors_(n),
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
    factors_.solve(right_, out.error);
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
    factors_.solve(right_, g_[number]);
  }

  /// `near` = slope, of second order, at the first of three rates `change` apart; far_ is the third. A
  /// first-order one would be kIncrement p/(p - p_a) off, which a stiff balance just above p_a turns into as
  /// much error in each step.
  void to_slope(const Vector& here, double change, Vector& near) const {
    for (std::size_t i = 0; i < near.size(); ++i)
      near[i] = (4.0 * (near[i] - here[i]) - (far_[i] - here[i])) / (2.0 * change);
  }

  /// rate_ = difference of the rates when one slot changes, over the change.
  void difference(Rates& rates, const Vector& dydx, std::size_t slot, double change, double x) {
    const double kept = y_[slot];
    change = (kept + change) - kept;  // exact, as the difference is divided by it
    y_[slot] = kept + change;
    rates(y_, rate_, x);
    y_[slot] = kept + 2.0 * change;
    rates(y_, far_, x);
    y_[slot] = kept;
    to_slope(dydx, change, rate_);
  }

  void subtract_column(std::size_t column, double factor) {
    for (std::size_t i = 0; i < rate_.size(); ++i) factors_.at(i, column) -= factor * rate_[i];
  }

  /// Forward in x by what changes p by kIncrement of it, at most kStepShare of the step; exact in x.
  double time_increment(const Rates& rates, double x, double h) const {
    const FlowBalance& balance = rates.balance;
    const double t = rates.time(x), energy = balance.point().pressure * balance.point().volume;
    const double change = kIncrement * energy / std::abs(balance.closed_pressure_growth(t));
    const double increment = change > 0.0 ? rates.position(t + change) - x : kStepShare * h;
    const double chosen = std::max(std::min(increment, kStepShare * h),
                                   8.0 * std::numeric_limits<double>::epsilon() * std::abs(x));
    return (x + chosen) - x;
  }

  /// Factors of 1/(gamma h) - J, and slope_, the rates' derivative with x.
  void fill_matrix(Rates& rates, const Vector& y, const Vector& dydx, double x, double h) {
    const FlowBalance& balance = rates.balance;
    y_ = y;
    rates.balance.locate(y, rates.time(x));
    const double mass = balance.point().mass, energy = balance.point().thermal_energy;
    for (std::size_t i = 0; i < y.size(); ++i)
      for (std::size_t j = 0; j < y.size(); ++j)
        factors_.at(i, j) = i == j ? 1.0 / (coefficients_.gamma * h) : 0.0;
    const double increment = time_increment(rates, x, h);
    rates(y_, slope_, x + increment);
    rates(y_, far_, x + 2.0 * increment);
    to_slope(dydx, increment, slope_);
    if (mass > 0.0) {  // else nothing has left yet
      // More of what is there, so that no mass turns negative.
      for (std::size_t k = 0; k < balance.species(); ++k) {
        difference(rates, dydx, k, -kIncrement * mass, x);
        subtract_column(k, 1.0);
        for (std::size_t b = 0; b < balance.backflows(); ++b)
          subtract_column(balance.back_slot(b), -balance.air_fraction(k));
      }
      difference(rates, dydx, balance.work_slot(), -kIncrement * energy, x);
      subtract_column(balance.work_slot(), 1.0);
      subtract_column(balance.heat_slot(), 1.0);
      for (std::size_t s = 0; s < balance.streams(); ++s) subtract_column(balance.out_slot(s) + 1, 1.0);
      for (std::size_t b = 0; b < balance.backflows(); ++b)
        subtract_column(balance.back_slot(b), -balance.back_enthalpy());
    }
    factors_.factorize();
  }

  const boost::numeric::odeint::default_rosenbrock_coefficients<double> coefficients_{};
  Factors factors_;
  Vector y_, rate_, far_, slope_, right_;
  std::array<Vector, 5> g_;
};

}  // namespace

std::unique_ptr<Stepper> make_rosenbrock_stepper(const FlowBalance& balance) {
  return std::make_unique<RosenbrockStepper>(balance.unknowns());
}

}  // namespace gas
