// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <span>

#include "boundary.hpp"
#include "compensated_sum.hpp"

namespace gas {

/// Content of the volume, and the amounts that crossed its boundary. The gas (m_k, U) is carried from
/// sub-step to sub-step, with the energy of (G.19) in place of U if the volume follows p:
///   m_k = m_k(t0) + delivered_k - out_k + Y_ak sum back,
///   U = U(t0) + delivered enthalpy - sum enthalpy + h_a sum back - work - heat.
/// Counted from the begin of the step instead, the gas of a tiny volume would be a difference of far larger
/// sums.
class Ledger {
 public:
  /// `boundary` must outlive this object. A species may be overdrawn by the share `negligible` of the gas; it
  /// is then used up.
  Ledger(const Boundary& boundary, double negligible);

  /// `work` [J] is (G.19) of `state`.
  void begin_step(const ControlVolumeState& state, double work);
  /// The times below count from the begin of a segment.
  void begin_segment() { time_ = 0.0; }
  /// Adds what flows in until t.
  void deliver(double t);

  /// Gas at the start of the sub-step.
  const Vector& gas() const { return gas_; }
  /// Computes `gas` at time t of a sub-step with the unknowns y. False if a species is overdrawn.
  bool gas_at(const Vector& y, double t, Vector& gas);
  /// Sets negative masses to zero if they are negligible, or round-off of the content and of `passed` [kg].
  /// False if a mass is further below zero.
  bool clear_lacking(Vector& gas, double passed);
  /// The overdrawn species when gas_at() or clear_lacking() returned false.
  std::optional<std::size_t> depleted() const { return depleted_; }
  /// Fills `change` with the change of the gas by the unknowns y.
  void change(const Vector& y, Vector& change) const;
  /// Ends a sub-step with y at t; the next one begins there. If a species is overdrawn, the excess is taken
  /// out of y. The masses of the outgoing streams are scaled to the sum of the outgoing species.
  void accept(Vector& y, double t);
  /// Removes flow that goes the wrong way by an error of the method, and adds it to `error`. Returns its mass
  /// [kg].
  double stop_reversed(Vector& y, Vector& error) const;

  double total(std::size_t slot) const { return totals_[slot].value(); }  // over the step
  void set_total(std::size_t slot, double value) { totals_[slot] = value; }
  StreamFlux delivered(std::size_t i) const {  // by inflow i, over the step
    return {received_[i].mass.value(), received_[i].enthalpy.value()};
  }

 private:
  void update_gas();

  const Boundary& boundary_;
  const double negligible_;
  double time_ = 0.0;  // [s] of the segment; gas_ and totals count up to here
  std::vector<CompensatedSum> sums_, totals_;
  Vector gas_;  // values of sums_
  struct Received {
    CompensatedSum mass, enthalpy;
  };
  std::vector<Received> received_;
  std::optional<std::size_t> depleted_;
};

}  // namespace gas
