// SPDX-License-Identifier: Apache-2.0
#include "engine/state.hpp"

#include <Eigen/Geometry>
#include <limits>
#include <numeric>

#include "engine/drift.hpp"
#include "engine/stages.hpp"
#include "step/ambient_energies.hpp"

namespace driver {
namespace {

void start_gas(const Scene& scene, State& state) {
  const GasPart& part = *scene.gas;
  const double volume = enclosure(scene, state).volume;
  state.gas = gas::make_state(part.model, part.initial_fractions, part.initial_pressure,
                              part.initial_temperature, volume);
  state.gas_integrator.emplace(part.model, part.integrator);
  state.start.gas_mass = std::accumulate(state.gas.masses.begin(), state.gas.masses.end(), 0.0);
  state.start.volume = volume;
  state.start.masses = state.gas.masses;
  state.start.ambient_energy = species_at_ambient(scene);
  state.streams.inflows.resize(part.model.inflows.size());
  state.streams.outflows.resize(part.model.vents.size() + part.model.fabric_count());
  state.streams.outflow_ambient.resize(state.streams.outflows.size());
  state.streams.backflows.resize(part.model.vents.size());
  state.gas_events.opened.assign(part.model.vents.size(), std::numeric_limits<double>::quiet_NaN());
  state.streams.ambient = ambient_energies(scene, state);
  if (!scene.output.streams) return;
  state.level.masses = state.gas.masses;
  state.level.streams = state.streams;
}

void start_target(const Scene& scene, State& state) {
  const auto& target = *scene.target;
  const int count = static_cast<int>(target.triangles.cols());
  state.target.area_vectors = membrane::Vectors(count);
  state.target.centroids = membrane::Vectors(count);
  for (int e = 0; e < count; ++e) {
    const Eigen::Vector3d a = target.nodes.col(target.triangles(0, e));
    const Eigen::Vector3d b = target.nodes.col(target.triangles(1, e));
    const Eigen::Vector3d c = target.nodes.col(target.triangles(2, e));
    state.target.area_vectors.map().col(e) = 0.5 * (b - a).cross(c - a);
    state.target.centroids.map().col(e) = ((a + b) + c) / 3.0;
  }
}

JetSkin jet_skin(const JetPart& part, Eigen::Index elements) {
  JetSkin skin;
  const bool moving = part.field.model().relative_to_skin;
  if (moving) skin.velocity.setZero(3, elements);
  if (!part.pieces) return skin;
  const auto pieces = part.pieces->triangles().cols();
  skin.nodes.resize(3, part.pieces->node_count());
  skin.area_vectors.resize(3, pieces);
  skin.centroids.resize(3, pieces);
  if (moving) skin.piece_velocity.setZero(3, pieces);
  return skin;
}

JetRun start_jet(const JetPart& part, const Eigen::Matrix3Xi& triangles) {
  jet::FieldState elements;
  if (part.pieces) {
    elements.overpressure.assign(static_cast<std::size_t>(triangles.cols()), 0.0);
    elements.candidates.reserve(elements.overpressure.size());
  }
  return {{},
          jet_skin(part, triangles.cols()),
          part.field.make_state(),
          std::move(elements),
          std::vector<std::uint8_t>(static_cast<std::size_t>(part.query->element_count())),
          *part.query,
          {},
          {},
          Eigen::Vector3d::Zero()};
}

void start_jets(const Scene& scene, State& state) {
  const auto& triangles = scene.bag ? scene.bag->mesh.elements : scene.target->triangles;
  for (const JetPart& part : scene.jets) {
    state.jets.push_back(start_jet(part, triangles));
    state.jets.back().query.prepare();  // steps do not allocate
  }
  state.jet_loads.reserve(scene.jets.size());
}

}  // namespace

std::string_view stage_name(Stage stage) {
  static constexpr std::string_view names[] = {"S1_surface", "S2_gas_point", "S3_forces",     "S4_contact",
                                               "S5_outlet",  "S6_jet_field", "S7_visibility", "S8_advance",
                                               "S9_volume",  "S10_gas",      "S11_ledger"};
  return names[static_cast<std::size_t>(stage)];
}

State make_state(const Scene& scene) {
  State state;
  state.start.smallest_energy = smallest_energy(scene);
  if (scene.bag) {
    const membrane::LoadKinds loads{!scene.jets.empty(), scene.contact || scene.skin_contact};
    state.bag = membrane::make_state(scene.bag->model, scene.bag->initial_position, loads);
    if (scene.driven) state.bag->own_force = membrane::Vectors(scene.bag->model.node_count);
    membrane::update_skin(scene.bag->model, *state.bag, ParallelBlocks{Executor::serial()});
  }
  if (scene.gas && scene.has_volume()) start_gas(scene, state);
  if (scene.target) start_target(scene, state);
  if (!scene.jets.empty()) start_jets(scene, state);
  if (scene.pendulum) {
    state.pendulum.emplace();
    state.pendulum->motion = scene.pendulum->initial;
  }
  if (scene.body) {
    state.body.emplace();
    state.body->motion = scene.body->model.initial();
  }
  if (scene.contact) state.contact_cache = scene.contact->make_state();
  if (scene.skin_contact) state.skin_contact_cache = scene.skin_contact->make_state();
  return state;
}

}  // namespace driver
