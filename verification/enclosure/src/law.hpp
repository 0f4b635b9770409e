// SPDX-License-Identifier: Apache-2.0
// The balances of a tank as a tape, for one side of each surface.
#pragma once

#include "tank.hpp"

namespace enclosure {

/// (G.8) to (G.11) in the unknowns mass, pressure and mass fractions of all species but the last, in which
/// outflow does not change the fractions. With the mass m, temperature T = p V/(m R) and mixture's cv, R:
///   m' = sum w_i + b - o,  Y_k' = (sum w_i (Y_ik - Y_k) + b (Y_ak - Y_k))/m,
///   m cv T' = sum w_i (h_i - sum Y_ik u_k(T)) + b (h_a - sum Y_ak u_k(T)) - o R T - p V' - h A (T - T_ext),
///   V p' = (sum w_i R_i + b R_a - o R) T + R/cv (m cv T') - p V',
/// w_i inflows, b backflow, o outflow: (G.10) less (G.9) times u_k. The pressure is an unknown because flows
/// near ambient pressure depend on a small difference: of an m and a T that move, its range would be wide.
class Law {
 public:
  /// `wide`: with factors that are finite over boxes that reach p_a, but move more with p within one.
  Law(const Tank& tank, const Regime& regime, bool wide);
  Law(const Law&) = delete;
  Law& operator=(const Law&) = delete;

  const Tape& tape() const { return tape_; }
  /// What is asked for besides the rates.
  std::vector<int> outputs() const;
  std::vector<int> rates;           // of each unknown
  std::vector<int> streams;         // [kg/s] of inflators, then holes and fabrics (out), then holes (back)
  std::vector<int> surfaces;        // what is positive above each surface
  int volume = 0, energy_rate = 0;  // [m3], [W] of the internal energy

 private:
  struct Gas;
  Term horner(const Balls& coefficients, Term x);
  Gas gas(const Regime& regime);
  Term total(const std::vector<Term>& terms);
  Term curve(const Curve& curve, Term y, const Regime& regime);
  Term laminar(Term y);
  Term hole_flux(Term p, Term density, Term gamma, Term outside, bool choked);
  void flows(const Gas& gas, const Regime& regime);
  void balances(const Gas& gas);
  bool above(const Regime& regime, double offset) const;

  const Tank& tank_;
  const bool wide_;
  Tape tape_;
  std::vector<Term> in_, enthalpy_in_, out_, back_;
};

}  // namespace enclosure
