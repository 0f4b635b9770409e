// SPDX-License-Identifier: Apache-2.0
// The balances of a tank as a tape, for one side of each surface.
#pragma once

#include "tank.hpp"

namespace enclosure {

/// (G.8) to (G.11) in the unknowns mass, temperature and mass fractions of all species but the last, in which
/// outflow does not change the fractions. With the mass m, temperature T and mixture's cv, R:
///   m' = sum w_i + b - o,  Y_k' = (sum w_i (Y_ik - Y_k) + b (Y_ak - Y_k))/m,
///   m cv T' = sum w_i (h_i - sum Y_ik u_k(T)) + b (h_a - sum Y_ak u_k(T)) - o R T - p V' - h A (T - T_ext),
/// w_i inflows, b backflow, o outflow: (G.10) less (G.9) times u_k.
class Law {
 public:
  Law(const Tank& tank, const Regime& regime);
  Law(const Law&) = delete;
  Law& operator=(const Law&) = delete;

  const Tape& tape() const { return tape_; }
  std::vector<int> rates;     // of each unknown
  std::vector<int> streams;   // [kg/s] of inflators, then holes and fabrics (out), then holes (back)
  std::vector<int> surfaces;  // what is positive above each surface
  int pressure = 0, volume = 0, energy = 0;  // [Pa], [m3], [J] internal
  int energy_rate = 0;                       // [W] dU/dt

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
  Tape tape_;
  std::vector<Term> in_, enthalpy_in_, out_, back_;
};

}  // namespace enclosure
