// SPDX-License-Identifier: Apache-2.0
// Rodas 4(3), L-stable, with the coefficients of Boost.Odeint (whose own stepper allocates in each step). The
// rates of the unknowns y depend on the gas w = (m_k, U) alone, so w is stepped beside them:
//   y' = r(w, t),  w' = in(t) + S r(w, t).
// Inflow is a rate of the gas here. If far more gas passes through in a step than the volume holds, the gas
// hardly changes, and each stage sees that. The matrix is solved in the parts z of RateSlopes: there each
// part speeds up its own outflow, so all pivots are positive.
#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>

#include "rate_slopes.hpp"
#include "stepper.hpp"

namespace gas {
namespace {

/// Dense LU factors in place, without pivoting. The row of an absent species has only its diagonal and keeps
/// it to the bit, so that no mass of it appears.
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

class Rodas : public Stepper {
 public:
  explicit Rodas(const Slots& slots)
      : slopes_(slots),
        factors_(slots.species + 1),
        stage_gas_(slots.species + 1),
        column_(slots.species + 1) {
    for (Pair* pair : {&rate_, &slope_, &right_}) *pair = {Vector(slots.size()), Vector(slots.species + 1)};
    g_.fill(rate_);
  }

  void step(System& system, const Vector&, double x, double h, bool, Trial& out) override {
    evaluate(system, {}, x);
    fill_matrix(system, x, h);
    // d4, the sum of gamma_ij, is -0.0362. Odeint 1.74 has the wrong sign, which reduces the order to 1 if
    // rates depend on time.
    const auto& c = coefficients_;
    solve_stage(h, {}, c.d1, g_[0]);
    const auto stage = [&](std::size_t number, std::initializer_list<double> shifts, double node,
                           std::initializer_list<double> weights, double d) {
      evaluate(system, shifts, x + node * h);
      solve_stage(h, weights, d, g_[number]);
    };
    stage(1, {c.a21}, c.c2, {c.c21}, c.d2);
    stage(2, {c.a31, c.a32}, c.c3, {c.c31, c.c32}, c.d3);
    stage(3, {c.a41, c.a42, c.a43}, c.c4, {c.c41, c.c42, c.c43}, -c.d4);
    stage(4, {c.a51, c.a52, c.a53, c.a54}, 1.0, {c.c51, c.c52, c.c53, c.c54}, 0.0);
    stage(5, {c.a51, c.a52, c.a53, c.a54, 1.0}, 1.0, {c.c61, c.c62, c.c63, c.c64, c.c65}, 0.0);
    out.error = g_[5].flows;
    for (std::size_t i = 0; i < out.end.size(); ++i)
      out.end[i] = sum(&Pair::flows, i, {c.a51, c.a52, c.a53, c.a54, 1.0, 1.0});
    system.rates(out.end, out.end_rate, x + h);
  }
  double error_power() const override { return 4.0; }

 private:
  /// Changes of the unknowns, and of the gas.
  struct Pair {
    Vector flows, gas;
  };

  /// sum weights g, at place i of one part.
  double sum(Vector Pair::*part, std::size_t i, std::initializer_list<double> weights) const {
    double result = 0.0;
    const Pair* g = g_.data();
    for (const double weight : weights) result += weight * ((g++)->*part)[i];
    return result;
  }

  /// rate_ at the gas of the start + sum shifts g.
  void evaluate(System& system, std::initializer_list<double> shifts, double x) {
    const Vector& begin = system.ledger.gas();
    for (std::size_t i = 0; i < begin.size(); ++i) stage_gas_[i] = begin[i] + sum(&Pair::gas, i, shifts);
    system.valid = system.valid && system.ledger.clear_lacking(stage_gas_, 0.0);
    system.rates_of(stage_gas_, rate_.flows, x);
    system.ledger.change(rate_.flows, rate_.gas);
    const double t = system.clock.time(x);
    system.balance.boundary().inflows().add(
        system.clock.slope(x), [&](const InflowSegment& in) { return in.rate(t); }, rate_.gas);
  }

  /// Solves for the g of the right side rate_ + h d slope_ + sum weights g / h.
  void solve_stage(double h, std::initializer_list<double> weights, double d, Pair& g) {
    for (const auto part : {&Pair::flows, &Pair::gas})
      for (std::size_t i = 0; i < (right_.*part).size(); ++i)
        (right_.*part)[i] = (rate_.*part)[i] + h * d * (slope_.*part)[i] + sum(part, i, weights) / h;
    g.gas = right_.gas;
    to_parts(g.gas);
    factors_.solve(g.gas);
    for (std::size_t i = 0; i < g.flows.size(); ++i) {
      double rate = right_.flows[i];
      for (std::size_t part = 0; part < g.gas.size(); ++part) rate += slopes_.by_part[part][i] * g.gas[part];
      g.flows[i] = coefficients_.gamma * h * rate;
    }
    for (std::size_t k = 0; k + 1 < g.gas.size(); ++k) g.gas.back() += slopes_.part_energy[k] * g.gas[k];
  }

  /// w to z.
  void to_parts(Vector& change) const {
    for (std::size_t k = 0; k + 1 < change.size(); ++k) change.back() -= slopes_.part_energy[k] * change[k];
  }

  /// Fills slopes_ in x, slope_, and the factors of 1/(gamma h) - S d(rates)/dz at the located gas.
  void fill_matrix(System& system, double x, double h) {
    const Clock& clock = system.clock;
    const double t = clock.time(x), s = clock.slope(x), s2 = clock.slope_of_slope();
    slopes_.fill(system.balance);
    const Inflows& inflows = system.balance.boundary().inflows();
    for (std::size_t i = 0; i < slope_.flows.size(); ++i)
      slope_.flows[i] = s * s * slopes_.by_time[i] + (s > 0.0 ? s2 / s * rate_.flows[i] : 0.0);
    system.ledger.change(slope_.flows, slope_.gas);
    inflows.add(
        s * s, [&](const InflowSegment& in) { return in.rate_slope(t); }, slope_.gas);
    inflows.add(
        s2, [&](const InflowSegment& in) { return in.rate(t); }, slope_.gas);
    for (std::size_t part = 0; part < slopes_.by_part.size(); ++part) {
      for (double& slope : slopes_.by_part[part]) slope *= s;
      system.ledger.change(slopes_.by_part[part], column_);
      to_parts(column_);
      for (std::size_t i = 0; i < column_.size(); ++i)
        factors_.at(i, part) = (i == part ? 1.0 / (coefficients_.gamma * h) : 0.0) - column_[i];
    }
    factors_.factorize();
  }

  const boost::numeric::odeint::default_rosenbrock_coefficients<double> coefficients_{};
  RateSlopes slopes_;
  Factors factors_;
  Vector stage_gas_, column_;
  Pair rate_, slope_, right_;
  std::array<Pair, 6> g_;
};

}  // namespace

std::unique_ptr<Stepper> make_rodas(const Slots& slots) {
  return std::make_unique<Rodas>(slots);
}

}  // namespace gas
