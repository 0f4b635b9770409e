// SPDX-License-Identifier: Apache-2.0
#include "network.hpp"

#include <algorithm>

#include "enclosure/enclose.hpp"

namespace enclosure {
namespace {

/// A node's switching, and what it comes from: the pressure passes `level` at `event`, `delay` earlier.
struct Switching {
  Ball time, event, delay;
  double level;
  bool rises;
};

/// Two that come from different events may have the same ball, and yet different times.
bool same_time(const Switching& a, const Switching& b) {
  if (!arb_equal(a.time.get(), b.time.get())) return false;
  return arb_is_exact(a.time.get()) ||
         (a.level == b.level && a.rises == b.rises && arb_equal(a.event.get(), b.event.get()) &&
          arb_equal(a.delay.get(), b.delay.get()));
}

void require_order(const Switching& earlier, const Switching& later) {
  if (!(later.time - earlier.time).is_positive()) throw Refusal(order_is_open);
}

/// A switching of an input.
struct Change {
  Switching at;
  std::size_t input;
};

/// Switching of a gate's condition.
std::vector<Switching> condition(const Gate& gate, const std::vector<std::vector<Switching>>& nodes) {
  std::vector<Change> changes{{{}, gate.inputs.size()}};  // at time 0 a condition may hold already
  for (std::size_t i = 0; i < gate.inputs.size(); ++i)
    for (const Switching& at : nodes[gate.inputs[i]]) changes.push_back({at, i});
  std::stable_sort(changes.begin(), changes.end(),
                   [](const Change& a, const Change& b) { return a.at.time.middle() < b.at.time.middle(); });
  std::vector<bool> on(gate.inputs.size() + 1, false);
  std::vector<Switching> result;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    on[changes[i].input] = !on[changes[i].input];
    const bool last_at_this_time = i + 1 == changes.size() || !same_time(changes[i].at, changes[i + 1].at);
    if (!last_at_this_time) continue;
    if (i + 1 < changes.size()) require_order(changes[i].at, changes[i + 1].at);
    const auto inputs_end = on.end() - 1;
    const bool holds = gate.logic == Gate::Logic::all ? std::find(on.begin(), inputs_end, false) == inputs_end
                       : gate.logic == Gate::Logic::any
                           ? std::find(on.begin(), inputs_end, true) != inputs_end
                           : !on[0];
    if (holds != (result.size() % 2 == 1)) result.push_back(changes[i].at);
  }
  return result;
}

/// The condition holds for the delay first.
std::vector<Switching> delayed(const Gate& gate, const std::vector<Switching>& condition) {
  std::vector<Switching> result;
  const Ball delay(gate.delay);
  for (std::size_t i = 0; i < condition.size(); i += 2) {
    Switching on = condition[i];
    on.time = later(on.time, delay);
    on.delay = later(on.delay, delay);
    if (gate.latch) return {on};
    if (i + 1 < condition.size() && gate.delay > 0.0) {
      if ((on.time - condition[i + 1].time).is_positive()) continue;
      require_order(on, condition[i + 1]);
    }
    result.push_back(on);
    if (i + 1 < condition.size()) result.push_back(condition[i + 1]);
  }
  return result;
}

}  // namespace

std::vector<Balls> switching_times(const Scene& scene, const std::vector<Balls>& events) {
  std::vector<std::vector<Switching>> nodes;
  for (std::size_t i = 0; i < scene.sensors.size(); ++i) {
    const Sensor& s = scene.sensors[i];
    nodes.emplace_back();
    if (s.threshold)
      for (const Ball& t : events[i]) {
        const bool rises = nodes.back().size() % 2 == 0;
        nodes.back().push_back({t, t, {}, rises ? *s.threshold : s.reset.value_or(0.0), rises});
      }
    else
      for (double t : s.switching) nodes.back().push_back({Ball(t), Ball(t), {}, 0.0, false});
  }
  for (const Gate& gate : scene.gates) nodes.push_back(delayed(gate, condition(gate, nodes)));
  std::vector<Balls> times;
  for (const std::vector<Switching>& node : nodes) {
    times.emplace_back();
    for (const Switching& at : node) times.back().push_back(at.time);
  }
  return times;
}

std::vector<bool> sensors_that_act(const Scene& scene) {
  std::vector<bool> acts(scene.sensors.size() + scene.gates.size(), false);
  for (const Inflator& inflator : scene.inflators)
    if (inflator.node) acts[*inflator.node] = true;
  for (const Hole& hole : scene.holes)
    if (hole.node) acts[*hole.node] = true;
  for (std::size_t i = scene.gates.size(); i-- > 0;)
    if (acts[scene.sensors.size() + i])
      for (std::size_t input : scene.gates[i].inputs) acts[input] = true;
  acts.resize(scene.sensors.size());
  return acts;
}

}  // namespace enclosure
