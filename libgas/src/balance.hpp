// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "boundary.hpp"

namespace gas {

/// Right-hand side of (G.9), (G.10) for the unknowns of Slots. locate() sets gas and time; fill_rates()
/// computes the rates.
class Balance {
 public:
  /// `boundary` must outlive this object.
  explicit Balance(const Boundary& boundary);

  /// Guess of the temperature [K] for the first gas.
  void begin_step(double temperature) { gas_.temperature = temperature; }
  /// Locates the gas of the amount (m_k, energy) at time t of the segment. False if its temperature is out of
  /// range.
  bool locate(std::span<const double> amount, double t);
  /// Rates dy/dt at the located gas.
  void fill_rates(Vector& dydt);

  const Boundary& boundary() const { return boundary_; }
  const UniformGas& gas() const { return gas_; }
  const Mixture& mixture() const { return mixture_; }
  double time() const { return time_; }  // [s] since the begin of the segment
  double absolute_time() const { return boundary_.segment().begin + time_; }  // [s]
  double fraction(std::size_t k) const { return masses_[k] / gas_.mass; }

  /// V dp/dt [W] at the located gas: first by inflow, volume and walls alone, with the openings shut; then by
  /// a flow [kg/s] out through the openings (below zero: ambient gas in).
  double closed_growth() const;
  double open_growth(double flow) const;
  // The rates that fill_rates() found last:
  double flow() const { return flow_; }  // [kg/s] out through all openings; below zero: in
  double pressure_rate() const;          // [Pa/s]

 private:
  const Boundary& boundary_;
  double time_ = 0.0;
  Vector masses_;
  Mixture mixture_;
  UniformGas gas_{};
  double flow_ = 0.0;
};

}  // namespace gas
