// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "gas/trigger.hpp"

namespace gas {

/// Evaluates a TriggerModel along a step. Everything that depends on time alone switches at known moments, so
/// those are break points; pressure thresholds are levels for the integrator to locate.
class TriggerNetwork {
 public:
  /// `model` must outlive this.
  explicit TriggerNetwork(const TriggerModel& model);

  /// First time after t at which a sensor of time or signal, or a running delay, may switch a node.
  double next_break(const TriggerState& state, double t) const;
  /// Brings every node to time t; true if a gate or sensor came on or went off. A pressure sensor switches
  /// where the integrator locates its threshold [Pa, over the ambient pressure]. Input sensors keep what the
  /// caller set.
  bool update(TriggerState& state, double t, double overpressure, double ambient_pressure) const;
  /// Whether a pressure sensor is no longer what `state` says it is.
  bool switches(const TriggerState& state, double overpressure, double ambient_pressure) const;
  /// True while a pressure sensor may still switch something.
  bool watches_pressure(const TriggerState& state) const;

 private:
  bool sensor_on(std::size_t i, const NodeState& node, double t, double overpressure,
                 double ambient_pressure) const;
  bool gate_condition(const Gate& gate, const TriggerState& state) const;
  bool update_gate(const Gate& gate, NodeState& node, const TriggerState& state, double t) const;

  const TriggerModel& model_;
  std::vector<std::vector<double>> switching_;  // [s] of each sensor, rising; on and off take turns
  std::vector<bool> starts_on_;                 // of each sensor, before the first of them
};

}  // namespace gas
