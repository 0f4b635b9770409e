// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "gas/trigger.hpp"

namespace gas {

/// Evaluates a TriggerModel along a step. Nodes that depend on time alone switch at known moments, which are
/// break points. Pressure thresholds are levels that the integrator locates.
class TriggerNetwork {
 public:
  /// `model` must outlive this object.
  explicit TriggerNetwork(const TriggerModel& model);

  /// First time after t at which a time sensor, a signal sensor or a running delay may switch a node.
  double next_break(const TriggerState& state, double t) const;
  /// Updates all nodes to time t. Pressure sensors compare `overpressure` [Pa] with their thresholds. Input
  /// sensors keep the caller's value.
  void update(TriggerState& state, double t, double overpressure, double ambient_pressure) const;
  /// True if a pressure sensor differs from its value in `state`.
  bool switches(const TriggerState& state, double overpressure, double ambient_pressure) const;
  /// True while a pressure sensor may still switch something.
  bool watches_pressure(const TriggerState& state) const;

 private:
  bool sensor_on(std::size_t i, const NodeState& node, double t, double overpressure,
                 double ambient_pressure) const;
  bool gate_condition(const Gate& gate, const TriggerState& state) const;
  bool update_gate(const Gate& gate, NodeState& node, const TriggerState& state, double t) const;

  const TriggerModel& model_;
  /// [s] of each sensor, rising; it goes on and off in turn.
  std::vector<std::vector<double>> switching_;
  std::vector<bool> starts_on_;  // of each sensor, before its first switching time
};

}  // namespace gas
