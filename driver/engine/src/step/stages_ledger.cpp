// SPDX-License-Identifier: Apache-2.0
// S11: mass, energy and momentum balance of level n, extremes of the run.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "engine/drift.hpp"
#include "engine/energy_terms.hpp"
#include "engine/impactor.hpp"
#include "engine/stages.hpp"

namespace driver {
namespace {

double gas_mass(const State& state) {
  return std::accumulate(state.gas.masses.begin(), state.gas.masses.end(), 0.0);
}

void book_kick(const Scene& scene, State& state, bool last) {
  if (state.contact.area > 0.0) {
    const double tau = 0.5 * (state.step.before + (last ? 0.0 : state.step.after));
    state.flows.contact_impulse += tau * state.contact.force.norm();
    const double along =
        state.pendulum ? state.pendulum->contact_moment / scene.pendulum->model.parameters().impactor_distance
                       : state.body->contact.force.dot(impactor_path(scene, state));
    state.flows.path_impulse += tau * along;
  }
  const StepSizes& step = state.step;
  if (state.pendulum) {
    state.flows.driving_work += state.pendulum->driving_work;
    state.level.flows.driving_work += state.pendulum->driving_work_before;
  }
  if (state.body) {
    state.flows.driving_work += state.body->driving_work;
    state.level.flows.driving_work += state.body->driving_work_before;
    state.flows.impactor_damping += state.body->kick.damping_loss;
    state.level.flows.impactor_damping += kick_share(step) * state.body->kick.damping_loss;
  }
  if (!state.bag) return;
  const auto& work = state.bag->advance.work;
  state.flows.kick_work += work.total();
  state.flows.damping_loss -= work.damping;
  state.level.flows.damping_loss -= kick_share(step) * work.damping;
  if (!state.bag->own_force.empty()) {
    state.flows.driving_work += work.own;
    state.level.flows.driving_work += work_before_level(step, state.level.own_power, work.own);
  }
  if (scene.bag->overpressure) {
    state.flows.pressure_work += work.pressure;
    state.level.flows.pressure_work += work_before_level(step, state.level.pressure_power, work.pressure);
  }
  if (scene.field) {
    state.flows.driving_work += work.gravity;
    state.level.flows.driving_work +=
        work_before_level(step, state.level.field.dot(state.bag->advance.momentum_before), work.gravity);
  }
  if (scene.jets.empty()) return;
  const double jet_before = work_before_level(step, state.level.jet_power, work.jet);
  if (scene.jet_work == JetWork::from_gas) {
    state.level.internal_energy -= jet_before;
  } else {
    state.flows.jet_work += work.jet;
    state.level.flows.jet_work += jet_before;
  }
}

double kinetic_after(const State& state) {
  return (state.bag ? state.bag->advance.kinetic_after : 0.0) +
         (state.pendulum ? state.pendulum->kinetic_after : 0.0) +
         (state.body ? state.body->kick.kinetic_after : 0.0);
}

double kinetic_before(const State& state) {
  return (state.bag ? state.bag->advance.kinetic_before : 0.0) +
         (state.pendulum ? state.pendulum->kinetic_before : 0.0) +
         (state.body ? state.body->kick.kinetic_before : 0.0);
}

// Sum of vectors and the sum of the magnitudes of their components. Two vectors at a time, with their zeros,
// so that the sums fill the processor's lanes.
struct VectorSums {
  Eigen::Vector3d sum, magnitude;
  explicit VectorSums(const membrane::Vectors& vectors) {
    double sums[8] = {}, magnitudes[8] = {};
    const double* values = vectors.data();
    const std::size_t size = 4 * static_cast<std::size_t>(membrane::padded(vectors.count()));
    for (std::size_t i = 0; i < size; i += 8)
      for (std::size_t k = 0; k < 8; ++k) {
        sums[k] += values[i + k];
        magnitudes[k] += std::abs(values[i + k]);
      }
    for (int k = 0; k < 3; ++k) {
      sum[k] = sums[k] + sums[k + 4];
      magnitude[k] = magnitudes[k] + magnitudes[k + 4];
    }
  }
};

// Inner forces and the pressure on a closed skin sum to zero: their resultant against the sum of magnitudes.
// The larger of that and `known`. The roots of the magnitudes are taken only if it may be the first: a
// vector's components sum to at most root 3 of its length.
double momentum_residual(const State& state, double known) {
  const auto& bag = *state.bag;
  const double pressure = bag.gauge_pressure;
  const VectorSums force(bag.membrane_force), gradient(bag.volume_gradient);
  const double resultant = (force.sum + pressure * gradient.sum).norm(),
               most = force.magnitude.sum() + std::abs(pressure) * gradient.magnitude.sum();
  if (std::numbers::sqrt3 * resultant <= known * most) return known;
  const double scale = bag.membrane_force.map().colwise().norm().sum() +
                       std::abs(pressure) * bag.volume_gradient.map().colwise().norm().sum();
  return scale > 0.0 ? std::max(known, resultant / scale) : known;
}

// Magnitude of that of all jets together.
double jet_force(const State& state) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const JetRun& run : state.jets) sum += run.force;
  return sum.norm();
}

void book_peaks(const Scene& scene, State& state) {
  Peaks& peaks = state.peaks;
  peaks.pressure = std::max(peaks.pressure, state.gas_point.pressure);
  peaks.volume = std::max(peaks.volume, state.level.volume);
  state.level.jet_force = jet_force(state);
  peaks.jet_force = std::max(peaks.jet_force, state.level.jet_force);
  if (scene.has_volume()) {
    const double supplied = state.start.gas_mass + state.flows.mass_in + state.flows.backflow_mass;
    const double expected = supplied - state.flows.vent_mass_out - state.flows.fabric_mass_out;
    if (supplied > 0.0)
      peaks.mass_residual = std::max(peaks.mass_residual, std::abs(gas_mass(state) - expected) / supplied);
  }
  if (state.pendulum) {
    peaks.pendulum_angle = std::max(peaks.pendulum_angle, std::abs(state.level.pendulum_angle));
    peaks.cg_acceleration = std::max(peaks.cg_acceleration, state.pendulum->acceleration.resultant);
  }
  if (state.body) {
    peaks.displacement = std::max(peaks.displacement, std::abs(state.body->displacement));
    peaks.acceleration = std::max(peaks.acceleration, state.body->acceleration.norm());
  }
  if (state.contact.area > 0.0 && peaks.first_contact < 0.0) peaks.first_contact = state.time;
  peaks.contact_force = std::max(peaks.contact_force, state.contact.force.norm());
  peaks.penetration = std::max(peaks.penetration, state.contact.penetration);
}

void book_self_contact(const Scene& scene, State& state) {
  if (!scene.skin_contact) return;
  SelfContactRecord& record = state.peaks.self_contact;
  const coupling::SkinContactResult& now = state.skin_contact;
  if (state.steps == 0) {
    record.limited_at_start = state.skin_contact_cache->limited_nodes();
    record.smallest_limit = state.skin_contact_cache->smallest_limit();
  }
  if (now.contacts > record.contacts) {
    record.contacts = now.contacts;
    record.contacts_time = state.time;
  }
  if (now.closest.gap < record.gap) {
    record.gap = now.closest.gap;
    record.gap_time = state.time;
  }
  if (100.0 * now.contacts >= scene.bag->model.node_count)
    record.one_room_from = std::numeric_limits<double>::infinity();
  else if (std::isinf(record.one_room_from))
    record.one_room_from = state.time;
}

void book_energy(const Scene& scene, State& state) {
  Peaks& peaks = state.peaks;
  peaks.energy_scale = std::max(peaks.energy_scale, energy_scale(scene, state));
  peaks.mechanical = std::max(peaks.mechanical, mechanical_energy(scene, state));
  // The energy of a level contains the step (K.40), that of the start does not. Of a skin that a constant
  // pressure sets in motion from rest the two differ by 2/(4 n^2 - 1) of its energy after n steps, 8e-4 at
  // 25; of one whose pressure rises from zero by some four times that.
  constexpr int fewest_steps = 25;
  if (!scene.moves() || state.steps >= fewest_steps)
    peaks.energy_residual = std::max(peaks.energy_residual, std::abs(state.level.energy_residual));
  const auto integrated = [&](Role role) {
    return scene.moves() ? role == Role::kinetic || role == Role::elastic : role == Role::held;
  };
  for (const EnergyTerm& term : energy_terms())
    if (integrated(term.role) && term.when(scene))
      if (const double size = std::abs(term.value(scene, state)); size > peaks.largest_term.magnitude)
        peaks.largest_term = {term.name, size};
}

double skin_kinetic(const State& state) {
  return membrane::level_kinetic(state.bag->advance, state.step.before, state.step.after);
}

}  // namespace

void ledger(const Scene& scene, State& state, const StepRequest& request) {
  StageTimer timer(state, Stage::ledger);
  const bool start = state.steps == 0 && state.step.before == 0.0;
  if (start) state.start.kinetic = kinetic_before(state);
  book_kick(scene, state, request.last);
  book_peaks(scene, state);
  book_self_contact(scene, state);
  Level& level = state.level;
  level.kick_residual = kinetic_after(state) - state.start.kinetic - state.flows.kick_work;
  state.peaks.ledger_residual = std::max(state.peaks.ledger_residual, std::abs(level.kick_residual));
  if (!request.record) return;

  if (state.bag) level.skin_kinetic = skin_kinetic(state);
  if (start) state.start.energy = held_energy(scene, state);
  level.energy_residual = energy_residual(scene, state);
  book_energy(scene, state);
  if (state.bag && scene.gas)
    state.peaks.momentum_residual = momentum_residual(state, state.peaks.momentum_residual);
}

}  // namespace driver
