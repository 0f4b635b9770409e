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
  double wall_conductance() const { return boundary_.model().heat_loss.conductance; }  // [W/K]
  double time() const { return time_; }                                                // [s]
  /// [J] done since the begin of the step by a volume that follows p.
  double work() const {
    return gas_.work - work_begin_;
  }  // [J] since the step's begin, of a volume that follows p
  /// The same for a mixture at a temperature [K].
  double work_at(const Mixture& mixture, double temperature) const {
    return locator_.work_at(mixture, temperature) - work_begin_;
  }
  double fraction(std::size_t k) const { return masses_[k] / gas_.mass; }

  // Of the gas located and the rates filled last:
  double outflow() const { return outflow_; }    // [kg/s] through all openings
  double backflow() const { return backflow_; }  // [kg/s]
  double closed_growth() const { return boundary_.closed_growth(gas_, time_); }
  double pressure_rate() const;  // [Pa/s]
  /// Relaxation rate [1/s] at `gas`: that of the walls (G.16) plus that of outflow, the faster of (G.14), or
  /// of p by backflow.
  double relaxation(const UniformGas& gas) const;
  /// The gas at which to linearise. If the overpressure at which flow balances its feed is farther from p_a,
  /// the gas is taken there: in between the law has another slope at each place, and p leaves that range at
  /// once.
  UniformGas where_linear() const;
  /// Overpressure [Pa] at which the flow of holes and fabric balances its feed; 0 if nothing feeds them.
  double balanced_overpressure() const;

 private:
  const Boundary& boundary_;
  const GasLocator locator_;
  double work_begin_ = 0.0;  // [J] (G.19)
  double time_ = 0.0;
  Vector masses_;
  Mixture mixture_;
  UniformGas gas_{};
  double outflow_ = 0.0, backflow_ = 0.0;
  UniformGas moved(double overpressure) const;
};

/// Derivatives of the rates of a Balance. The gas has parts z: the mass of each species, taken to come at the
/// gas's own temperature, and last its energy (G.23).
class RateSlopes {
 public:
  explicit RateSlopes(const Slots& slots);
  /// For the gas that `balance` has located.
  void fill(const Balance& balance);

  std::vector<Vector> by_part;  // [part] d(dy/dt)/dz
  Vector by_time;               // d(dy/dt)/dt with the gas held
  /// [J/kg] Energy that comes with 1 kg of each species; 1 for the last part.
  Vector part_energy;

 private:
  /// Derivatives of p, T, R, gamma and h by a part.
  struct Change {
    double pressure, temperature, gas_constant, gamma, enthalpy;
    double of(const Flow& flow) const {
      return flow.pressure * pressure + flow.temperature * temperature + flow.gas_constant * gas_constant +
             flow.gamma * gamma;
    }
  };
  void fill_changes(const Balance& balance, const UniformGas& gas);
  void add_outflow(const Balance& balance, const UniformGas& gas, double pressure_by_time);

  std::vector<Change> changes_;
};

}  // namespace gas
