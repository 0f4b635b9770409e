// SPDX-License-Identifier: Apache-2.0
#include "driver/step.hpp"

#include "step/stages.hpp"

namespace driver {

std::string_view stage_name(Stage stage) {
  static constexpr std::string_view names[] = {"S1_surface",    "S2_gas_point", "S3_outlet",  "S4_jet_field",
                                               "S5_visibility", "S6_forces",    "S7_contact", "S8_advance",
                                               "S9_volume",     "S10_gas",      "S11_ledger"};
  return names[static_cast<std::size_t>(stage)];
}

void step(const Scene& scene, State& state, const StepRequest& request, const Executor& executor) {
  // S1: the surface of level n was written by S9 of the step before (make_state, at the start).
  gas_point(scene, state);
  outlets(scene, state);
  jet_fields(scene, state);
  visibility(scene, state);
  forces(scene, state, executor);
  contact(scene, state);
  if (request.before_advance) (*request.before_advance)(state);
  if (request.record) {
    state.level.skin_gravity = skin_gravity(scene, state);
    state.level.displacement = skin_displacement(scene, state);
  }
  choose_step(scene, state, request.last);
  advance(scene, state, executor);
  const Enclosure before = enclosure(scene, state);
  if (!request.last) {
    volume(scene, state, executor);
    gas_ode(scene, state, before);
  }
  ledger(scene, state, request);
  state.step.before = state.step.after;
}

State state_at_start(const Scene& scene) {
  State state = make_state(scene);
  gas_point(scene, state);
  forces(scene, state, Executor::serial());
  return state;
}

}  // namespace driver
