// SPDX-License-Identifier: Apache-2.0
#include "jet_states.hpp"

#include "engine/run.hpp"
#include "results/load_scene.hpp"

namespace benchmarks {

driver::Scene passenger_scene(const std::vector<std::string>& overrides) {
  driver::CaseDocument document(GASJET_SOURCE_DIR "/cases/passenger_pendulum.toml", overrides);
  return driver::load_scene(document);
}

std::vector<JetState> jet_states(const driver::Scene& scene, const std::vector<double>& times) {
  driver::State state = driver::make_state(scene);
  std::vector<JetState> states;
  while (states.size() < times.size()) {
    driver::evaluate_level(scene, state, {});
    if (state.time >= times[states.size()])
      states.push_back(
          {state.time, state.bag->position.map(), state.bag->velocity.map(), state.jets.front().outlet});
    driver::advance_level(scene, state, {});
    state.time += state.step.after;
  }
  return states;
}

}  // namespace benchmarks
