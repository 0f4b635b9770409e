// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "gas/curve.hpp"

/// What fires an inflator or opens a vent: sensors, combined by logic. The nodes of a TriggerModel are its
/// sensors, then its gates; a gate reads nodes before itself, so there are no loops.
namespace gas {

/// What a sensor watches.
enum class SensorKind {
  time,      // on from `threshold` [s]
  signal,    // on while the supplied signal is `threshold` or more
  pressure,  // on from the moment when p - p_a reaches `threshold` [Pa]; off again below `reset`, if given
  input,     // set by the caller between steps (contact): acts from the next step
};

/// A node that watches one thing.
struct Sensor {
  SensorKind kind;                // decides which of the others are read
  double threshold = 0.0;         // [s], the signal's unit, [Pa]; not used by input
  std::optional<double> reset{};  // [Pa] < threshold, pressure only: without it the sensor stays on
  std::optional<Curve> signal{};  // signal only
};

/// When a gate's condition holds: all inputs on, any on, or its one input off.
enum class Logic { all, any, negated };

/// A node that joins earlier ones.
struct Gate {
  Logic logic;                      // of its condition
  std::vector<std::size_t> inputs;  // nodes before this one; negated: exactly one
  double delay = 0.0;               // [s] on only after its condition has held so long ...
  bool latch = false;               // ... or, latched, so long after it first held; then it stays on
};

/// The nodes and how they hang together; validate() checks it.
struct TriggerModel {
  std::vector<Sensor> sensors;  // nodes 0, 1, ...
  std::vector<Gate> gates;      // the nodes that follow
  /// Number of nodes.
  std::size_t size() const { return sensors.size() + gates.size(); }
};

/// One node's memory. A node that has never been on has first_on = infinity.
struct NodeState {
  bool on = false;                                              // now
  double since = std::numeric_limits<double>::infinity();       // [s] when it last came on
  double first_on = std::numeric_limits<double>::infinity();    // [s] when it first came on
  double held_since = std::numeric_limits<double>::infinity();  // [s] since when a gate's condition holds
};

using TriggerState = std::vector<NodeState>;  // one per node

/// Throws std::invalid_argument, naming the node's field and what is allowed, unless thresholds and delays
/// are finite, delays not negative, a reset lies below its threshold, a signal sensor has a signal that is
/// held outside its knots, and gates read earlier nodes only.
void validate(const TriggerModel& model);

/// Sets an input sensor; the integrator takes it into account at the start of its next step. Throws
/// std::invalid_argument if `node` is no such sensor.
void set_input(const TriggerModel& model, std::size_t node, bool on, TriggerState& state);

}  // namespace gas
