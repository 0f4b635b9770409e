// SPDX-License-Identifier: Apache-2.0
#include "engine/step.hpp"

#include "engine/stages.hpp"

namespace driver {

namespace {

void jets_of_kick(const Scene& scene, State& state) {
  jet_fields(scene, state);
  visibility(scene, state);
}

// Where jets have a say in the next step, it is first taken to be as long as the last one: at the start, and
// if they damp the skin.
bool jets_before_step(const Scene& scene, State& state) {
  const bool start = state.step.before == 0.0;
  if (scene.jets.empty() || !(start || jets_damp(scene))) return false;
  state.step.after = state.step.before;
  state.step.kick_end = state.time + 0.5 * state.step.after;
  outlets(scene, state);
  jets_of_kick(scene, state);
  if (start) jet_forces(scene, state);
  return !start;
}

// Loads that the case gives over time, as means over the kick: from where the last one ended to half of the
// step after n.
void loads_of_kick(const Scene& scene, State& state, bool jets_known) {
  state.step.kick_end = state.time + 0.5 * state.step.after;
  outlets(scene, state);
  if (!jets_known || !rescale_jets(state)) jets_of_kick(scene, state);
  book_jets(scene, state);
  jet_forces(scene, state);
  prescribed_pressure(scene, state);
}

}  // namespace

void evaluate_level(const Scene& scene, State& state, const StepRequest& request, const Executor& executor) {
  // S1: the surface of level n was written by S9 of the step before (make_state, at the start).
  gas_point(scene, state);
  forces(scene, state, executor);
  contact(scene, state);
  const bool jets_known = jets_before_step(scene, state);
  choose_step(scene, state, request.last);
  loads_of_kick(scene, state, jets_known);
  if (request.record) look_at_level(scene, state);
}

void advance_level(const Scene& scene, State& state, const StepRequest& request, const Executor& executor) {
  advance(scene, state, executor);
  const Enclosure before = enclosure(scene, state);
  if (!request.last) {
    volume(scene, state, executor);
    gas_ode(scene, state, before);
  }
  ledger(scene, state, request);
  state.step.before = state.step.after;
  state.step.kick_begin = state.step.kick_end;
}

void step(const Scene& scene, State& state, const StepRequest& request, const Executor& executor) {
  evaluate_level(scene, state, request, executor);
  advance_level(scene, state, request, executor);
}

State state_at_start(const Scene& scene) {
  State state = make_state(scene);
  gas_point(scene, state);
  forces(scene, state, Executor::serial());
  prescribed_pressure(scene, state);
  return state;
}

}  // namespace driver
