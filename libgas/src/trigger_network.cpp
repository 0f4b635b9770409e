// SPDX-License-Identifier: Apache-2.0
#include "trigger_network.hpp"

#include <algorithm>

#include "limits.hpp"

namespace gas {
namespace {

// Relative to the pressure: a threshold is located to 1e-12, and as much again for the rounding
// there.
constexpr double kThresholdNear = 2e-12;

/// Times at which the piecewise linear signal crosses the threshold. A signal at the threshold is on.
std::vector<double> crossings(const Curve& signal, double threshold) {
  std::vector<double> times;
  const auto knots = signal.knots();
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const auto &l = knots[i - 1], &r = knots[i];
    if ((l.value >= threshold) == (r.value >= threshold)) continue;
    const double share = (threshold - l.value) / (r.value - l.value);
    times.push_back(std::clamp(l.time + share * (r.time - l.time), l.time, r.time));
  }
  return times;
}

/// `since` shows whether the node was on; `on` does not, because the caller sets it for an input.
void set(NodeState& node, bool on, double t) {
  if (on && node.since == kInfinity) node.since = t;
  if (!on) node.since = kInfinity;
  if (on) node.first_on = std::min(node.first_on, t);
  node.on = on;
}

}  // namespace

TriggerNetwork::TriggerNetwork(const TriggerModel& model) : model_(model) {
  for (const Sensor& sensor : model.sensors) {
    const bool of_signal = sensor.kind == SensorKind::signal;
    starts_on_.push_back(of_signal && sensor.signal->knots().front().value >= sensor.threshold);
    switching_.emplace_back();
    if (of_signal) switching_.back() = crossings(*sensor.signal, sensor.threshold);
    if (sensor.kind == SensorKind::time) switching_.back() = {sensor.threshold};
  }
}

double TriggerNetwork::next_break(const TriggerState& state, double t) const {
  double next = kInfinity;
  for (const auto& times : switching_) {
    const auto later = std::ranges::upper_bound(times, t);
    if (later != times.end()) next = std::min(next, *later);
  }
  for (std::size_t i = 0; i < model_.gates.size(); ++i) {
    const NodeState& node = state[model_.sensors.size() + i];
    const double end = node.held_since + model_.gates[i].delay;
    if (!node.on && end > t) next = std::min(next, end);
  }
  return next;
}

bool TriggerNetwork::sensor_on(std::size_t i, const NodeState& node, double t, double overpressure,
                               double ambient_pressure) const {
  const Sensor& sensor = model_.sensors[i];
  if (sensor.kind == SensorKind::input) return node.on;
  if (sensor.kind == SensorKind::pressure) {
    const auto near = [&](double level) {
      return kThresholdNear * (ambient_pressure + std::max(0.0, level));
    };
    if (!node.on) return overpressure >= sensor.threshold - near(sensor.threshold);
    return !sensor.reset || overpressure > *sensor.reset + near(*sensor.reset);
  }
  const auto passed = std::ranges::upper_bound(switching_[i], t) - switching_[i].begin();
  return starts_on_[i] != (passed % 2 == 1);
}

bool TriggerNetwork::gate_condition(const Gate& gate, const TriggerState& state) const {
  const auto is_on = [&](std::size_t input) { return state[input].on; };
  if (gate.logic == Logic::negated) return !is_on(gate.inputs.front());
  return gate.logic == Logic::all ? std::ranges::all_of(gate.inputs, is_on)
                                  : std::ranges::any_of(gate.inputs, is_on);
}

bool TriggerNetwork::update_gate(const Gate& gate, NodeState& node, const TriggerState& state,
                                 double t) const {
  const bool holds = gate_condition(gate, state);
  if (holds && node.held_since == kInfinity) node.held_since = t;
  if (!holds && !gate.latch) node.held_since = kInfinity;
  return t >= node.held_since + gate.delay;
}

void TriggerNetwork::update(TriggerState& state, double t, double overpressure,
                            double ambient_pressure) const {
  const std::size_t sensors = model_.sensors.size();
  for (std::size_t i = 0; i < model_.size(); ++i)
    set(state[i],
        i < sensors ? sensor_on(i, state[i], t, overpressure, ambient_pressure)
                    : update_gate(model_.gates[i - sensors], state[i], state, t),
        t);
}

bool TriggerNetwork::switches(const TriggerState& state, double overpressure, double ambient_pressure) const {
  for (std::size_t i = 0; i < model_.sensors.size(); ++i)
    if (model_.sensors[i].kind == SensorKind::pressure &&
        sensor_on(i, state[i], 0.0, overpressure, ambient_pressure) != state[i].on)
      return true;
  return false;
}

bool TriggerNetwork::watches_pressure(const TriggerState& state) const {
  for (std::size_t i = 0; i < model_.sensors.size(); ++i)
    if (model_.sensors[i].kind == SensorKind::pressure && (!state[i].on || model_.sensors[i].reset))
      return true;
  return false;
}

}  // namespace gas
