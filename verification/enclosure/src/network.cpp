// SPDX-License-Identifier: Apache-2.0
#include "network.hpp"

#include <algorithm>

#include "enclosure/enclose.hpp"

namespace enclosure {
namespace {

/// A node's switching.
struct Change {
  Ball time;
  std::size_t input;
};

void require_order(const Ball& earlier, const Ball& later) {
  if (!(later - earlier).is_positive())
    throw Refusal("two sensors or gates switch within the uncertainty of their times");
}

/// Switching of a gate's condition.
Balls condition(const Gate& gate, const std::vector<Balls>& nodes) {
  std::vector<Change> changes{{Ball(0.0), gate.inputs.size()}};
  for (std::size_t i = 0; i < gate.inputs.size(); ++i)
    for (const Ball& t : nodes[gate.inputs[i]]) changes.push_back({t, i});
  std::stable_sort(changes.begin(), changes.end(),
                   [](const Change& a, const Change& b) { return a.time.middle() < b.time.middle(); });
  std::vector<bool> on(gate.inputs.size() + 1, false);
  Balls result;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    on[changes[i].input] = !on[changes[i].input];
    const bool last_at_this_time =
        i + 1 == changes.size() || !arb_equal(changes[i].time.get(), changes[i + 1].time.get());
    if (!last_at_this_time) continue;
    if (i + 1 < changes.size()) require_order(changes[i].time, changes[i + 1].time);
    const auto inputs_end = on.end() - 1;
    const bool holds = gate.logic == Gate::Logic::all ? std::find(on.begin(), inputs_end, false) == inputs_end
                       : gate.logic == Gate::Logic::any
                           ? std::find(on.begin(), inputs_end, true) != inputs_end
                           : !on[0];
    if (holds != (result.size() % 2 == 1)) result.push_back(changes[i].time);
  }
  return result;
}

/// The condition holds for the delay first.
Balls delayed(const Gate& gate, const Balls& condition) {
  Balls result;
  const Ball delay(gate.delay);
  for (std::size_t i = 0; i < condition.size(); i += 2) {
    const Ball on = later(condition[i], delay);
    if (gate.latch) return {on};
    if (i + 1 < condition.size() && gate.delay > 0.0) {
      if ((on - condition[i + 1]).is_positive()) continue;
      require_order(on, condition[i + 1]);
    }
    result.push_back(on);
    if (i + 1 < condition.size()) result.push_back(condition[i + 1]);
  }
  return result;
}

}  // namespace

std::vector<Balls> switching_times(const Scene& scene, const std::vector<Balls>& events) {
  std::vector<Balls> nodes;
  for (std::size_t i = 0; i < scene.sensors.size(); ++i)
    nodes.push_back(scene.sensors[i].threshold
                        ? events[i]
                        : Balls(scene.sensors[i].switching.begin(), scene.sensors[i].switching.end()));
  for (const Gate& gate : scene.gates) nodes.push_back(delayed(gate, condition(gate, nodes)));
  return nodes;
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
