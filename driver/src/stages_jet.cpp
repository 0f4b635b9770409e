// SPDX-License-Identifier: Apache-2.0
// S3 outlet, S4 jet field, S5 visibility.
#include <algorithm>

#include "stages.hpp"

namespace driver {
namespace {

struct Skin {
  jet::Points nodes, area_vectors, centroids;
};

Skin skin(const Scene& scene, const State& state) {
  if (state.bag) return {state.bag->position.map(), state.bag->area_vector.map(), state.bag->centroid.map()};
  return {scene.target->nodes, state.target_area_vectors.map(), state.target_centroids.map()};
}

}  // namespace

void outlets(const Scene& scene, State& state) {
  if (scene.jets.empty()) return;
  StageTimer timer(state, Stage::outlet);
  for (std::size_t j = 0; j < scene.jets.size(); ++j) {
    const auto point = gas::inflator_point(scene.gas->model, scene.jets[j].inflator, state.time);
    const double pressure = scene.has_volume() ? state.gas_point.pressure : scene.ambient.pressure;
    state.jets[j].outlet = jet::outlet_state(
        scene.jets[j].outlet, {point.mass_flow, point.temperature, point.cp, point.gas_constant, pressure});
  }
}

void jet_fields(const Scene& scene, State& state) {
  if (scene.jets.empty()) return;
  StageTimer timer(state, Stage::jet_field);
  const Skin now = skin(scene, state);
  for (std::size_t j = 0; j < scene.jets.size(); ++j)
    scene.jets[j].field.evaluate(now.area_vectors, now.centroids, state.jets[j].outlet, state.jets[j].field);
}

void visibility(const Scene& scene, State& state) {
  if (scene.jets.empty()) return;
  StageTimer timer(state, Stage::visibility);
  const Skin now = skin(scene, state);
  for (std::size_t j = 0; j < scene.jets.size(); ++j) {
    const JetPart& part = scene.jets[j];
    JetRun& run = state.jets[j];
    run.counters = {};
    if (part.occlusion && !run.field.candidates.empty()) {
      const std::span<std::uint8_t> lit(run.lit.data(), run.field.candidates.size());
      run.counters = run.query.query(part.route, now.nodes, jet::ray_source(part.field.model()),
                                     run.field.candidates, lit);
      jet::apply_mask(lit, run.field);
    } else {
      run.counters.candidates = run.counters.lit = run.field.candidates.size();
    }
    run.total.candidates += run.counters.candidates;
    run.total.lit += run.counters.lit;
    run.total.hidden += run.counters.hidden;
    run.total.facing_away += run.counters.facing_away;
    run.total.exact_calls += run.counters.exact_calls;
    run.total.fallbacks += run.counters.fallbacks;
    run.total.tree_builds += run.counters.tree_builds;
    run.force = jet::jet_force(run.field, now.area_vectors);
  }
}

}  // namespace driver
