// SPDX-License-Identifier: Apache-2.0
// S3 outlet, S4 jet field, S5 visibility.
#include <algorithm>

#include "step/stages.hpp"

namespace driver {
namespace {

struct Skin {
  jet::Points nodes, area_vectors, centroids;
};

Skin elements(const Scene& scene, const State& state) {
  if (state.bag) return {state.bag->position.map(), state.bag->area_vector.map(), state.bag->centroid.map()};
  return {scene.target->nodes, state.target_area_vectors.map(), state.target_centroids.map()};
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

}  // namespace

void outlets(const Scene& scene, State& state) {
  if (scene.jets.empty()) return;
  StageTimer timer(state, Stage::outlet);
  for (std::size_t j = 0; j < scene.jets.size(); ++j) {
    const auto point = gas::inflator_point(scene.gas->model, state.gas, scene.jets[j].inflator, state.time);
    const double pressure = scene.has_volume() ? state.gas_point.pressure : scene.ambient.pressure;
    state.jets[j].outlet = jet::outlet_state(
        scene.jets[j].outlet, {point.mass_flow, point.temperature, point.cp, point.gas_constant, pressure});
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
    run.total += run.counters;
    if (part.pieces) part.pieces->average(run.field, run.elements);
    run.force = jet::jet_force(run.load(), skin.area_vectors);
  }
}

}  // namespace driver
