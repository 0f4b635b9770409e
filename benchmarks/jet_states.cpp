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
  const std::function<void(const driver::State&)> keep = [&](const driver::State& now) {
    if (states.size() < times.size() && now.time >= times[states.size()])
      states.push_back({now.time, now.bag->position.map(), now.bag->velocity.map(), now.jets.front().outlet});
  };
  driver::StepRequest request;
  request.before_advance = &keep;
  while (states.size() < times.size()) {
    driver::step(scene, state, request);
    state.time += state.step.after;
  }
  return states;
}

}  // namespace benchmarks
