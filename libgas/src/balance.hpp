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

  /// `state` is that at the start. Throws DomainError if its temperature is out of range.
  void begin_step(const ControlVolumeState& state);
  /// Locates the gas (m_k, U) at time t. False if its temperature is out of range.
  bool locate(std::span<const double> gas, double t);
  /// Rates dy/dt of the gas located.
  void fill_rates(Vector& dydt);

  const Boundary& boundary() const { return boundary_; }
  const UniformGas& gas() const { return gas_; }
  const Mixture& mixture() const { return mixture_; }
  double time() const { return time_; }  // [s]
  /// Work [J] since the begin of the step by a volume that follows p.
  double work() const { return gas_.work - work_begin_; }
  /// The same for a mixture at a temperature [K].
  double work_at(const Mixture& mixture, double temperature) const {
    return locator_.work_at(mixture, temperature) - work_begin_;
  }
  double fraction(std::size_t k) const { return masses_[k] / gas_.mass; }

  // Of the gas located and the rates filled last:
  double outflow() const { return outflow_; }    // [kg/s] through all openings
  double backflow() const { return backflow_; }  // [kg/s]
  double closed_growth() const { return gas::closed_growth(boundary_, gas_, time_); }
  double pressure_rate() const;  // [Pa/s]

 private:
  const Boundary& boundary_;
  const GasLocator locator_;
  double work_begin_ = 0.0;  // [J] (G.19)
  double time_ = 0.0;
  Vector masses_;
  Mixture mixture_;
  UniformGas gas_{};
  double outflow_ = 0.0, backflow_ = 0.0;
};

}  // namespace gas
