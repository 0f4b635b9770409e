// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "boundary.hpp"

namespace gas {

/// The right-hand side of (G.9), (G.10) for the unknowns of Slots, at one gas and time: locate() tells which,
/// fill_rates() has one line for each term, all else is about them.
class Balance {
 public:
  /// `boundary` must outlive this.
  explicit Balance(const Boundary& boundary);

  /// `state` is that at the start. Throws DomainError if its temperature is out of range.
  void begin_step(const ControlVolumeState& state);
  /// The gas (m_k, U) at time t, or, if its temperature is out of range, none: false.
  bool locate(std::span<const double> gas, double t);
  /// dy/dt of the gas located.
  void fill_rates(Vector& dydt);

  const Boundary& boundary() const { return boundary_; }
  const UniformGas& gas() const { return gas_; }
  const Mixture& mixture() const { return mixture_; }
  double wall_conductance() const { return boundary_.model().heat_loss.conductance; }  // [W/K]
  double time() const { return time_; }                                                // [s]
  double work() const {
    return gas_.work - work_begin_;
  }  // [J] since the step's begin, of a volume that follows p
  /// The same of a mixture at that temperature.
  double work_at(const Mixture& mixture, double temperature) const {
    return locator_.work_at(mixture, temperature) - work_begin_;
  }
  double fraction(std::size_t k) const { return masses_[k] / gas_.mass; }

  // Of the gas located and the rates filled last:
  double outflow() const { return outflow_; }    // [kg/s] through all openings
  double backflow() const { return backflow_; }  // [kg/s]
  double closed_growth() const { return boundary_.closed_growth(gas_, time_); }
  double pressure_rate() const;  // [Pa/s]
  /// The faster rate [1/s] of outflow at `gas`, (G.14), or that of p by backflow, and of the walls, (G.16).
  double relaxation(const UniformGas& gas) const;
  /// The gas, or as if it were at the overpressure where what flows would balance its feed, if that is
  /// farther from p_a: in between the law has another slope at each place, and p leaves there at once.
  UniformGas where_linear() const;
  /// That overpressure [Pa], of holes and fabric; 0 if nothing feeds them.
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

/// Derivatives of the rates of a Balance. A part z of the gas is the mass of a species that comes at the
/// gas's own temperature or, the last one, its energy. (G.23)
class RateSlopes {
 public:
  explicit RateSlopes(const Slots& slots);
  /// Of the gas that `balance` has located.
  void fill(const Balance& balance);

  std::vector<Vector> by_part;  // d(dy/dt)/dz, one vector for each part
  Vector by_time;               // the same by the time, the gas held
  Vector part_energy;           // [J/kg] that 1 kg of each species takes along; of the last part 1

 private:
  /// How p, T, R, gamma and h follow a part.
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
