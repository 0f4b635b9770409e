// SPDX-License-Identifier: Apache-2.0
// S5 outlet, S6 jet field, S7 visibility.
#include <algorithm>
#include <cmath>

#include "engine/stages.hpp"
#include "step/mean_outlet.hpp"

namespace driver {
namespace {

struct Skin {
  jet::Points nodes, area_vectors, centroids;
};

Skin elements(const Scene& scene, const State& state) {
  if (state.bag) return {state.bag->position.map(), state.bag->area_vector.map(), state.bag->centroid.map()};
  return {scene.target->nodes, state.target.area_vectors.map(), state.target.centroids.map()};
}

Skin asked(const Skin& elements, const JetPart& part, const JetRun& run) {
  if (!part.pieces) return elements;
  return {run.skin.nodes, run.skin.area_vectors, run.skin.centroids};
}

void place_pieces(const jet::Subdivision& pieces, const Skin& elements, JetSkin& skin) {
  pieces.interpolate(elements.nodes, skin.nodes);
  pieces.share_areas(elements.area_vectors, skin.area_vectors);
  jet::corner_means(skin.nodes, pieces.triangles(), skin.centroids);
}

// Velocity of the elements' centroids at the half step before, all that is known at level n.
const Eigen::Matrix3Xd& place_velocities(const Scene& scene, const State& state, const JetPart& part,
                                         JetSkin& skin) {
  if (state.bag) jet::corner_means(state.bag->velocity.map(), scene.bag->mesh.elements, skin.velocity);
  if (!part.pieces) return skin.velocity;
  const int pieces = part.pieces->pieces();
  for (Eigen::Index e = 0; e < skin.velocity.cols(); ++e)
    skin.piece_velocity.middleCols(e * pieces, pieces).colwise() = skin.velocity.col(e);
  return skin.piece_velocity;
}

// Pieces need all elements; else the field knows which.
void place_elements(const Scene& scene, State& state, const JetPart& part, JetRun& run) {
  if (!state.bag) return;
  const auto& model = scene.bag->model;
  if (part.pieces) return membrane::update_geometry(model, *state.bag);
  membrane::update_geometry(model, *state.bag,
                            part.field.needed(run.outlet, state.step.displacement_bound, run.field));
}

void evaluate_field(const Scene& scene, State& state, const JetPart& part, JetRun& run) {
  place_elements(scene, state, part, run);
  const Skin skin = elements(scene, state);
  if (part.pieces) place_pieces(*part.pieces, skin, run.skin);
  const Skin seen = asked(skin, part, run);
  if (!part.field.model().relative_to_skin) {
    part.field.evaluate(seen.area_vectors, seen.centroids, run.outlet, run.field, nullptr,
                        state.step.displacement_bound);
    return;
  }
  const jet::Points velocity(place_velocities(scene, state, part, run.skin));
  part.field.evaluate(seen.area_vectors, seen.centroids, run.outlet, run.field, &velocity,
                      state.step.displacement_bound);
}

void mask(const JetPart& part, const jet::Points& nodes, double displacement_bound, JetRun& run) {
  run.counters = {};
  if (!part.occlusion || run.field.candidates.empty()) {
    run.counters.candidates = run.counters.lit = run.field.candidates.size();
    return;
  }
  const std::span<std::uint8_t> lit(run.lit.data(), run.field.candidates.size());
  run.counters = run.query.query(part.route, nodes, jet::ray_source(part.field.model()), run.field.candidates,
                                 lit, displacement_bound);
  jet::apply_mask(lit, run.field);
}

// Change of a jet's load on a plate, (1 + e V0/V) rho V^2 A, between two outlets; 0 if there was none.
double load_change(const jet::OutletState& before, const jet::OutletState& now, double restitution,
                   double area) {
  const double thrust = jet::momentum_flux(before, area);
  if (!(thrust > 0.0)) return 0.0;
  return jet::momentum_flux(now, area) / thrust *
         ((1.0 + restitution * now.reflected) / (1.0 + restitution * before.reflected));
}

double restitution(const JetPart& part, const State& state) {
  if (!part.restitution) return part.field.model().restitution;
  const double injected = state.flows.mass_in, contained = state.gas_point.mass;
  return part.restitution->value(contained > 0.0 ? injected / contained : 0.0);
}

double firing_time(const Scene& scene, const State& state, const JetPart& part) {
  return gas::firing_time(scene.gas->model.inflows[part.inflator], state.gas.triggers);
}

}  // namespace

void outlets(const Scene& scene, State& state) {
  if (scene.jets.empty()) return;
  StageTimer timer(state, Stage::outlet);
  const double pressure = scene.has_volume() ? state.gas_point.pressure : scene.ambient.pressure;
  for (std::size_t j = 0; j < scene.jets.size(); ++j) {
    const JetPart& part = scene.jets[j];
    const double firing = firing_time(scene, state, part);
    // S10 finds a firing within the step: what has blown since then is in no kick yet.
    const double begin =
        std::isfinite(state.jets[j].firing) ? state.step.kick_begin : std::min(state.step.kick_begin, firing);
    const jet::OutletState outlet = mean_outlet(
        scene, part, {begin - firing, state.step.kick_end - firing, kick_length(state.step)}, pressure);
    JetRun& run = state.jets[j];
    run.field.restitution = restitution(part, state);
    run.load_change = load_change(run.outlet, outlet, run.field.restitution, part.outlet.area);
    run.outlet = outlet;
  }
}

void jet_fields(const Scene& scene, State& state) {
  if (scene.jets.empty()) return;
  StageTimer timer(state, Stage::jet_field);
  for (std::size_t j = 0; j < scene.jets.size(); ++j)
    evaluate_field(scene, state, scene.jets[j], state.jets[j]);
}

void visibility(const Scene& scene, State& state) {
  if (scene.jets.empty()) return;
  StageTimer timer(state, Stage::visibility);
  const Skin skin = elements(scene, state);
  for (std::size_t j = 0; j < scene.jets.size(); ++j) {
    const JetPart& part = scene.jets[j];
    JetRun& run = state.jets[j];
    mask(part, asked(skin, part, run).nodes, state.step.displacement_bound, run);
    if (part.pieces) part.pieces->average(run.field, run.elements);
    run.force = jet::jet_force(run.load(), skin.area_vectors);
  }
}

void book_jets(const Scene& scene, State& state) {
  for (std::size_t j = 0; j < scene.jets.size(); ++j) {
    state.jets[j].total += state.jets[j].counters;
    state.jets[j].firing = firing_time(scene, state, scene.jets[j]);
  }
}

bool jets_damp(const Scene& scene) {
  return scene.bag && std::ranges::any_of(scene.jets, [](const JetPart& part) {
           return part.field.model().relative_to_skin;
         });
}

bool rescale_jets(State& state) {
  if (std::ranges::any_of(state.jets, [](const JetRun& run) { return !(run.load_change > 0.0); }))
    return false;
  for (JetRun& run : state.jets) {
    jet::FieldState& load = run.elements.overpressure.empty() ? run.field : run.elements;
    for (const int element : load.candidates)
      load.overpressure[static_cast<std::size_t>(element)] *= run.load_change;
    run.force *= run.load_change;
  }
  return true;
}

void jet_forces(const Scene& scene, State& state) {
  if (state.jets.empty() || !state.bag) return;
  StageTimer timer(state, Stage::forces);
  state.jet_loads.clear();
  for (const JetRun& run : state.jets)
    state.jet_loads.push_back({run.load().overpressure, run.load().candidates});
  membrane::jet_forces(scene.bag->model, *state.bag, std::span<const membrane::JetLoad>(state.jet_loads));
}

}  // namespace driver
