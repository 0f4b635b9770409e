// SPDX-License-Identifier: Apache-2.0
#include "engine/energy_terms.hpp"

#include "engine/scene_features.hpp"

namespace driver {
namespace {

using Of = const Scene&;
using At = const State&;

double ambient_work(Of scene, At now) {
  return now.start.ambient_work + scene.ambient.pressure * (now.level.volume - now.start.volume);
}

double pendulum_gravity(Of scene, At now) {
  return scene.pendulum->model.potential_energy(now.level.pendulum_angle);
}

// clang-format off
constexpr EnergyTerm kTerms[] = {
  {"gas_internal_J", Role::held, has::volume, [](Of, At now) { return now.level.internal_energy; }},
  {"skin_kinetic_J", Role::kinetic, has::bag, [](Of, At now) { return now.level.skin_kinetic; }},
  {"skin_strain_J", Role::elastic, has::bag, [](Of, At now) { return now.level.skin_strain; }},
  {"skin_gravity_J", Role::held, has::weight, [](Of, At now) { return now.level.skin_gravity; }},
  {"strap_J", Role::elastic, has::straps, [](Of, At now) { return now.bag->forces.strap_energy; }},
  {"plate_J", Role::elastic, has::plates, [](Of, At now) { return now.bag->forces.plate_energy; }},
  {"ambient_work_J", Role::spent, has::bag_of_gas, ambient_work},
  {"contact_J", Role::elastic, has::contact, [](Of, At now) { return now.contact.energy; }},
  {"self_contact_J", Role::elastic, has::self_contact, [](Of, At now) { return now.skin_contact.energy; }},
  {"pendulum_kinetic_J", Role::kinetic, has::pendulum, [](Of, At now) { return now.pendulum->kinetic; }},
  {"pendulum_gravity_J", Role::held, has::pendulum, pendulum_gravity},
  {"impactor_kinetic_J", Role::kinetic, has::body, [](Of, At now) { return now.body->kinetic; }},
  {"impactor_gravity_J", Role::held, has::body, [](Of, At now) { return now.body->gravity_energy; }},
  {"impactor_spring_J", Role::elastic, has::rail_springs, [](Of, At now) { return now.body->spring_energy; }},
  {"impactor_damping_J", Role::spent, has::rail_springs, [](Of, At now) { return now.level.flows.impactor_damping; }},
  {"outflow_enthalpy_J", Role::spent, has::volume, [](Of, At now) { return now.level.flows.enthalpy_out; }},
  {"inflow_enthalpy_J", Role::supplied, has::volume, [](Of, At now) { return now.level.flows.enthalpy_in; }},
  {"backflow_enthalpy_J", Role::supplied, has::backflow, [](Of, At now) { return now.level.flows.backflow_enthalpy; }},
  {"heat_loss_J", Role::spent, has::heat_loss, [](Of, At now) { return now.level.flows.heat_loss; }},
  {"tank_work_J", Role::spent, has::moving_tank, [](Of, At now) { return now.level.flows.gas_work; }},
  {"damping_J", Role::spent, has::damping, [](Of, At now) { return now.level.flows.damping_loss; }},
  {"friction_J", Role::spent, has::friction, [](Of, At now) { return now.flows.friction_loss; }},
  {"jet_work_J", Role::supplied, has::jets_on_bag, [](Of, At now) { return now.level.flows.jet_work; }},
  {"pressure_work_J", Role::supplied, has::prescribed_pressure, [](Of, At now) { return now.level.flows.pressure_work; }},
  {"driving_work_J", Role::supplied, has::driving, [](Of, At now) { return now.level.flows.driving_work; }},
  {"gas_sensible_J", Role::none, has::volume, [](Of, At now) { return now.level.internal_energy - now.level.ambient.held; }},
  {"outflow_sensible_J", Role::none, has::volume, [](Of, At now) { return now.level.flows.enthalpy_out - now.level.ambient.outflow; }},
  {"inflow_sensible_J", Role::none, has::volume, [](Of, At now) { return now.level.flows.enthalpy_in - now.level.ambient.inflow; }},
  {"backflow_sensible_J", Role::none, has::backflow, [](Of, At now) { return now.level.flows.backflow_enthalpy - now.level.ambient.backflow; }},
  {"residual_J", Role::none, has::anything, [](Of, At now) { return now.level.energy_residual; }},
  {"kick_residual_J", Role::none, has::motion, [](Of, At now) { return now.level.kick_residual; }},
};
// clang-format on

}  // namespace

std::span<const EnergyTerm> energy_terms() {
  return kTerms;
}

double sum_of(Role role, const Scene& scene, const State& state) {
  double sum = 0.0;
  for (const EnergyTerm& term : kTerms)
    if (term.role == role && term.when(scene)) sum += term.value(scene, state);
  return sum;
}

double held_energy(const Scene& scene, const State& state) {
  double sum = 0.0;
  for (const EnergyTerm& term : kTerms)
    if (is_held(term.role) && term.when(scene)) sum += term.value(scene, state);
  return sum;
}

double energy_residual(const Scene& scene, const State& state) {
  double sum = held_energy(scene, state);
  for (const EnergyTerm& term : kTerms)
    if (term.role == Role::spent && term.when(scene)) sum += term.value(scene, state);
  sum -= state.start.energy;
  for (const EnergyTerm& term : kTerms)
    if (term.role == Role::supplied && term.when(scene)) sum -= term.value(scene, state);
  return sum;
}

}  // namespace driver
