// SPDX-License-Identifier: Apache-2.0
// S11: mass, energy and momentum books of level n, extremes of the run.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "drift.hpp"
#include "stages.hpp"

namespace driver {
namespace {

double gas_mass(const State& state) {
  return std::accumulate(state.gas.masses.begin(), state.gas.masses.end(), 0.0);
}

void book_kick(const Scene& scene, State& state, bool last) {
  if (state.contact.area > 0.0) {
    const double tau = 0.5 * (state.step.before + (last ? 0.0 : state.step.after));
    state.flows.contact_impulse += tau * state.contact.force.norm();
    state.flows.path_impulse +=
        tau * state.pendulum->contact_moment / scene.pendulum->model.parameters().impactor_distance;
  }
  if (!state.bag) return;
  const auto& work = state.bag->advance.work;
  const double share = kick_share(state.step);
  state.flows.kick_work += work.total();
  state.flows.damping_loss -= work.damping;
  state.level.flows.damping_loss -= share * work.damping;
  if (scene.jets.empty()) return;
  if (scene.jets.front().work == JetWork::from_gas) {
    state.level.internal_energy -= share * work.jet;
  } else {
    state.flows.jet_work += work.jet;
    state.level.flows.jet_work += share * work.jet;
  }
}

double held(const EnergyRecord& e) {
  return e.gas_internal_J + e.skin_kinetic_J + e.skin_strain_J + e.skin_gravity_J + e.strap_J + e.plate_J +
         e.contact_J + e.pendulum_kinetic_J + e.pendulum_gravity_J + e.ambient_work_J;
}

EnergyRecord energy_record(const Scene& scene, const State& state) {
  EnergyRecord e;
  e.time_s = state.time;
  if (scene.has_volume()) {
    e.gas_internal_J = state.level.internal_energy;
    if (state.bag) e.ambient_work_J = scene.ambient.pressure * (state.level.volume - state.initial_volume);
  }
  if (state.bag) {
    e.skin_kinetic_J = level_kinetic(state.step, state.bag->advance.kinetic_before,
                                     state.bag->advance.kinetic_after, state.bag->advance.kinetic_product);
    e.skin_strain_J = state.level.skin_strain;
    e.strap_J = state.bag->forces.strap_energy;
    e.plate_J = state.bag->forces.plate_energy;
    e.skin_gravity_J = state.level.skin_gravity;
    e.contact_J = state.contact.energy;
  }
  if (state.pendulum) {
    e.pendulum_kinetic_J = state.pendulum->kinetic;
    e.pendulum_gravity_J = scene.pendulum->model.potential_energy(state.level.pendulum_angle);
  }
  const Flows& flows = state.level.flows;
  e.outflow_enthalpy_J = flows.enthalpy_out;
  e.damping_J = flows.damping_loss;
  e.friction_J = state.flows.friction_loss;
  e.inflow_enthalpy_J = flows.enthalpy_in;
  e.jet_work_J = flows.jet_work;
  e.backflow_enthalpy_J = flows.backflow_enthalpy;
  e.heat_loss_J = flows.heat_loss;
  if (!state.bag) e.tank_work_J = flows.gas_work;
  return e;
}

double kinetic_after(const State& state) {
  return (state.bag ? state.bag->advance.kinetic_after : 0.0) +
         (state.pendulum ? state.pendulum->kinetic_after : 0.0);
}

double kinetic_before(const State& state) {
  return (state.bag ? state.bag->advance.kinetic_before : 0.0) +
         (state.pendulum ? state.pendulum->kinetic_before : 0.0);
}

// Inner forces and the pressure on a closed skin sum to zero: their resultant against the sum of magnitudes.
double momentum_residual(const State& state) {
  const auto& bag = *state.bag;
  const Eigen::Vector3d resultant = bag.membrane_force.map().rowwise().sum() +
                                    bag.gauge_pressure * bag.volume_gradient.map().rowwise().sum();
  const double scale = bag.membrane_force.map().colwise().norm().sum() +
                       std::abs(bag.gauge_pressure) * bag.volume_gradient.map().colwise().norm().sum();
  return scale > 0.0 ? resultant.norm() / scale : 0.0;
}

double joint_force(const Scene& scene, const State& state) {
  const PendulumRun& p = *state.pendulum;
  return scene.pendulum->model
      .joint_reaction(state.level.pendulum_angle, p.angular_velocity, p.moment, state.contact.force)
      .norm();
}

// Of all jets together.
Eigen::Vector3d jet_force(const State& state) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const JetRun& run : state.jets) sum += run.force;
  return sum;
}

Record history_record(const Scene& scene, const State& state) {
  Record r;
  r.time_s = state.time;
  const auto& gas = state.gas_point;
  r.pressure_Pa = gas.pressure;
  r.temperature_K = gas.temperature;
  r.volume_m3 = state.level.volume;
  r.skin_area_m2 = state.level.skin_area;
  r.gas_mass_kg = gas.mass;
  r.inflow_kg_s = gas.inflow;
  r.vent_outflow_kg_s = gas.vent_mass_flow;
  r.fabric_outflow_kg_s = gas.fabric_mass_flow;
  r.backflow_kg_s = gas.backflow;
  r.heat_loss_W = gas.heat_loss;
  for (const JetRun& run : state.jets) {
    r.jet_lit_elements += static_cast<double>(run.counters.lit);
    r.jet_hidden_elements += static_cast<double>(run.counters.hidden);
  }
  r.jet_force_N = jet_force(state).norm();
  r.contact_force_N = state.contact.force.norm();
  r.contact_penetration_m = state.contact.penetration;
  if (state.pendulum) {
    r.pendulum_angle_rad = state.level.pendulum_angle;
    r.pendulum_angular_velocity_rad_s = state.pendulum->angular_velocity;
    r.pendulum_cg_tangential_m_s2 = state.pendulum->acceleration.tangential;
    r.pendulum_cg_radial_m_s2 = state.pendulum->acceleration.radial;
    r.pendulum_cg_acceleration_m_s2 = state.pendulum->acceleration.resultant;
    r.pendulum_joint_force_N = joint_force(scene, state);
  }
  if (state.bag) r.plate_force_N = state.bag->forces.plate_force.norm();
  if (state.bag && !state.bag->strap_tension.empty())
    r.strap_force_N = *std::max_element(state.bag->strap_tension.begin(), state.bag->strap_tension.end());
  return r;
}

void book_peaks(const Scene& scene, State& state) {
  Peaks& peaks = state.peaks;
  peaks.pressure = std::max(peaks.pressure, state.gas_point.pressure);
  peaks.volume = std::max(peaks.volume, state.level.volume);
  peaks.jet_force = std::max(peaks.jet_force, jet_force(state).norm());
  if (scene.has_volume()) {
    const double supplied = state.initial_gas_mass + state.flows.mass_in + state.flows.backflow_mass;
    const double expected = supplied - state.flows.vent_mass_out - state.flows.fabric_mass_out;
    if (supplied > 0.0)
      peaks.mass_residual = std::max(peaks.mass_residual, std::abs(gas_mass(state) - expected) / supplied);
  }
  if (state.pendulum) {
    peaks.pendulum_angle = std::max(peaks.pendulum_angle, std::abs(state.level.pendulum_angle));
    peaks.cg_acceleration = std::max(peaks.cg_acceleration, state.pendulum->acceleration.resultant);
  }
  if (state.contact.area > 0.0 && peaks.first_contact < 0.0) peaks.first_contact = state.time;
  peaks.contact_force = std::max(peaks.contact_force, state.contact.force.norm());
  peaks.penetration = std::max(peaks.penetration, state.contact.penetration);
}

void book_energy(const EnergyRecord& energy, Peaks& peaks) {
  peaks.energy_scale = std::max(peaks.energy_scale, energy_scale(energy));
  peaks.energy_residual = std::max(peaks.energy_residual, std::abs(energy.residual_J));
  for (const auto term : {&EnergyRecord::gas_internal_J, &EnergyRecord::skin_strain_J,
                          &EnergyRecord::skin_kinetic_J, &EnergyRecord::strap_J, &EnergyRecord::plate_J,
                          &EnergyRecord::contact_J, &EnergyRecord::pendulum_kinetic_J})
    peaks.energy.*term = std::max(peaks.energy.*term, std::abs(energy.*term));
}

}  // namespace

void ledger(const Scene& scene, State& state, const StepRequest& request, StepRecords& records) {
  StageTimer timer(state, Stage::ledger);
  const bool start = state.steps == 0 && state.step.before == 0.0;
  if (start) state.initial_kinetic = kinetic_before(state);
  book_kick(scene, state, request.last);
  book_peaks(scene, state);
  const double kick_residual = kinetic_after(state) - state.initial_kinetic - state.flows.kick_work;
  state.peaks.ledger_residual = std::max(state.peaks.ledger_residual, std::abs(kick_residual));
  if (!request.record) return;

  EnergyRecord& energy = records.energy;
  energy = energy_record(scene, state);
  if (start) state.initial_energy = held(energy);
  energy.residual_J = held(energy) + energy.outflow_enthalpy_J + energy.damping_J + energy.friction_J +
                      energy.heat_loss_J + energy.tank_work_J - state.initial_energy -
                      energy.inflow_enthalpy_J - energy.backflow_enthalpy_J - energy.jet_work_J;
  energy.kick_residual_J = kick_residual;
  book_energy(energy, state.peaks);
  if (state.bag)
    state.peaks.momentum_residual = std::max(state.peaks.momentum_residual, momentum_residual(state));
  records.history = history_record(scene, state);
}

}  // namespace driver
