// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "gas/curve.hpp"

/// Triggers: sensors and logic that fire inflators and open vents. The nodes of a TriggerModel are its
/// sensors, then its gates. A gate reads only nodes before itself, so there are no loops.
namespace gas {

/// Quantity that a sensor watches.
enum class SensorKind {
  time,      // on from the time `threshold` [s]
  signal,    // on while the signal is at or above `threshold`
  pressure,  // on from when p - p_a reaches `threshold` [Pa]; off below `reset`, if given
  input,     // set by the caller between steps; takes effect at the next step
};

/// A node that watches one quantity.
struct Sensor {
  SensorKind kind;                // decides which other members are used
  double threshold = 0.0;         // [s], unit of the signal, or [Pa]; not read by `input`
  std::optional<double> reset{};  // [Pa] < threshold, `pressure` only; none: the sensor stays on
  std::optional<Curve> signal{};  // `signal` only; held outside its knots
};

/// Condition of a gate: all inputs on, any input on, or its single input off.
enum class Logic { all, any, negated };

/// A node that combines earlier nodes.
struct Gate {
  Logic logic;                      // its condition
  std::vector<std::size_t> inputs;  // nodes before this one; `negated`: exactly one
  /// [s] >= 0. The gate is on once its condition has held for this long.
  double delay = 0.0;
  /// True: the delay counts from when the condition first held, and the gate then stays on.
  bool latch = false;
};

/// All nodes and their connections; validate() checks them.
struct TriggerModel {
  std::vector<Sensor> sensors;  // nodes 0, 1, ...
  std::vector<Gate> gates;      // the nodes that follow
  /// Number of nodes.
  std::size_t size() const { return sensors.size() + gates.size(); }
};

/// State of one node. Until it first comes on, its first_on is infinity.
struct NodeState {
  bool on = false;  // now
  /// [s] when it last came on; infinity while it is off.
  double since = std::numeric_limits<double>::infinity();
  /// [s] when it first came on.
  double first_on = std::numeric_limits<double>::infinity();
  /// [s] gates only: when the condition last became true (a latching gate: when it first did); infinity if it
  /// is false.
  double held_since = std::numeric_limits<double>::infinity();
};

using TriggerState = std::vector<NodeState>;  // one per node

/// Checks a model. Throws std::invalid_argument, naming the field and what is allowed, unless
/// - thresholds and delays are finite, and delays not negative,
/// - a reset belongs to a pressure sensor and lies below its threshold,
/// - a signal sensor, and no other, has a signal, held outside its knots,
/// - gates read earlier nodes only: `negated` one, the others one or more.
void validate(const TriggerModel& model);

/// Sets an input sensor. The integrator reads it at the start of its next step. Throws std::invalid_argument
/// if `node` is not an input sensor.
void set_input(const TriggerModel& model, std::size_t node, bool on, TriggerState& state);

/// Nodes that a node depends on, itself included: one flag per node. Throws std::out_of_range.
std::vector<bool> nodes_behind(const TriggerModel& model, std::size_t node);

/// Times [s] from 0 to `end` at which a node switches: on, off, on, and so on. Empty if the node depends on a
/// pressure or an input sensor, so that only a run can tell.
std::optional<std::vector<double>> switching_times(const TriggerModel& model, std::size_t node, double end);

}  // namespace gas
