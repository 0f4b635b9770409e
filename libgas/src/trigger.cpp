// SPDX-License-Identifier: Apache-2.0
#include "gas/trigger.hpp"

#include <cmath>
#include <string>

#include "require.hpp"
#include "trigger_network.hpp"

namespace gas {
namespace {

void validate(const Sensor& sensor) {
  require(sensor.kind >= SensorKind{} && sensor.kind <= SensorKind::input, "sensor.kind",
          static_cast<double>(sensor.kind), "must be one of its enumerators");
  if (sensor.kind != SensorKind::input)
    require(std::isfinite(sensor.threshold), "sensor.threshold", sensor.threshold, "must be finite");
  if (sensor.reset)
    require(sensor.kind == SensorKind::pressure && *sensor.reset < sensor.threshold, "sensor.reset [Pa]",
            *sensor.reset, "must be below the threshold of a pressure sensor");
  const bool has_signal = sensor.signal.has_value();
  require(has_signal == (sensor.kind == SensorKind::signal), "number of sensor.signal", has_signal,
          "must be 1 for a signal sensor, else 0");
  if (has_signal)
    require(sensor.signal->outside() == Outside::held, "sensor.signal", 0.0,
            "must be held outside its knots");
}

void validate(const Gate& gate, std::size_t node) {
  require(gate.logic >= Logic::all && gate.logic <= Logic::negated, "gate.logic",
          static_cast<double>(gate.logic), "must be one of its enumerators");
  const std::size_t most = gate.logic == Logic::negated ? 1 : node;
  require(!gate.inputs.empty() && gate.inputs.size() <= most, "number of gate.inputs",
          static_cast<double>(gate.inputs.size()), "must be 1 for not, else 1 or more");
  for (const std::size_t input : gate.inputs)
    require(input < node, "gate.inputs", static_cast<double>(input), "must be nodes before the gate");
  require(std::isfinite(gate.delay) && gate.delay >= 0.0, "gate.delay [s]", gate.delay,
          "must be finite and not negative");
}

}  // namespace

void validate(const TriggerModel& model) {
  for (const Sensor& sensor : model.sensors) validate(sensor);
  for (std::size_t i = 0; i < model.gates.size(); ++i) validate(model.gates[i], model.sensors.size() + i);
}

void set_input(const TriggerModel& model, std::size_t node, bool on, TriggerState& state) {
  require(node < model.sensors.size() && model.sensors[node].kind == SensorKind::input, "node",
          static_cast<double>(node), "must be an input sensor");
  state.at(node).on = on;
}

std::vector<bool> nodes_behind(const TriggerModel& model, std::size_t node) {
  std::vector<bool> behind(model.size(), false);
  behind.at(node) = true;
  for (std::size_t i = model.size(); i-- > model.sensors.size();)
    if (behind[i])
      for (const std::size_t input : model.gates[i - model.sensors.size()].inputs) behind[input] = true;
  return behind;
}

std::optional<std::vector<double>> switching_times(const TriggerModel& model, std::size_t node, double end) {
  const std::vector<bool> behind = nodes_behind(model, node);
  for (std::size_t i = 0; i < model.sensors.size(); ++i) {
    const SensorKind kind = model.sensors[i].kind;
    if (behind[i] && kind != SensorKind::time && kind != SensorKind::signal) return std::nullopt;
  }
  const TriggerNetwork network(model);
  TriggerState state(model.size());
  std::vector<double> times;
  for (double t = 0.0; t <= end; t = network.next_break(state, t)) {
    network.update(state, t, 0.0, 0.0);  // the pressure affects other nodes only
    const bool was_on = times.size() % 2 == 1;
    if (state[node].on != was_on) times.push_back(t);
  }
  return times;
}

}  // namespace gas
