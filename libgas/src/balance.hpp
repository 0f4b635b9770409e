// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "boundary.hpp"

namespace gas {

/// Right-hand side of (G.9), (G.10) for the unknowns of Slots, at one gas and time. locate() sets gas and
/// time; fill_rates() has one line for each term.
class Balance {
 public:
  /// `boundary` must outlive this object.
  explicit Balance(const Boundary& boundary);

  /// Guess of the temperature [K] for the first gas.
  void begin_step(double temperature) { gas_.temperature = temperature; }
  /// Locates the gas of the amount (m_k, energy) at time t. False if its temperature is out of range.
  bool locate(std::span<const double> amount, double t);
  /// Rates dy/dt of the gas located.
  void fill_rates(Vector& dydt);

  const Boundary& boundary() const { return boundary_; }
  const UniformGas& gas() const { return gas_; }
  const Mixture& mixture() const { return mixture_; }
  double time() const { return time_; }  // [s]
  double fraction(std::size_t k) const { return masses_[k] / gas_.mass; }

  // Of the gas located and the rates filled last:
  double flow() const { return flow_; }  // [kg/s] out through all openings; below zero what comes in
  double closed_growth() const { return gas::closed_growth(boundary_, gas_, time_); }
  double pressure_rate() const;  // [Pa/s]

 private:
  const Boundary& boundary_;
  double time_ = 0.0;
  Vector masses_;
  Mixture mixture_;
  UniformGas gas_{};
  double flow_ = 0.0;
};

}  // namespace gas
