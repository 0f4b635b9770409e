// SPDX-License-Identifier: Apache-2.0
// Stages S5 to S7 of the rectangular jet in the passenger bag: outlet, field, and visibility by each route.
// The counters say what was decided and that the routes agree.
#include <benchmark/benchmark.h>

#include <string>
#include <utility>

#include "jet/field.hpp"
#include "jet/visibility.hpp"
#include "jet_tree/tree_route.hpp"
#include "passenger_states.hpp"

namespace {

using benchmarks::PassengerState;
using benchmarks::Shape;

const PassengerState& saved(benchmark::State& run) {
  const auto shape = static_cast<Shape>(run.range(0));
  run.SetLabel(benchmarks::name_of(shape));
  return benchmarks::passenger_state(shape);
}

// The outlet of 0.0116 m2 in the middle of the attachment, blowing away from the plate.
jet::JetModel jet_model() {
  jet::JetModel m;
  m.shape = jet::OutletShape::rectangular;
  m.centre = {0.0, 0.0, 0.0};
  m.axis = {1.0, 0.0, 0.0};
  m.long_direction = {0.0, 1.0, 0.0};
  m.long_side = 0.16;
  m.short_side = 0.0725;
  m.decay_coefficient = 0.1;
  return jet::validated(m);
}

constexpr jet::OutletInput kInput{4.0, 406.0, 1038.8, 296.8, 120e3};  // at the flow's peak

jet::OutletState outlet(const jet::JetModel& model) {
  return jet::outlet_state(
      {jet::OutletLaw::sonic, jet::OutletTemperature::static_value, jet::outlet_area(model)}, kInput);
}

struct Field {
  const PassengerState& p;
  jet::JetModel model = jet_model();
  jet::OutletState out = outlet(model);
  jet::JetField field{model, p.model.element_count, p.null_elements};
  jet::FieldState state = field.make_state();
  explicit Field(const PassengerState& saved_state) : p(saved_state) { evaluate(); }
  void evaluate() { field.evaluate(p.state.area_vector.map(), p.state.centroid.map(), out, state); }
};

void BM_outlet(benchmark::State& run) {
  const jet::JetModel model = jet_model();
  jet::OutletState out;
  for (auto _ : run) {
    out = outlet(model);
    benchmark::DoNotOptimize(std::as_const(out));
  }
  run.counters["velocity_m_s"] = out.velocity;
  run.counters["momentum_N"] = jet::momentum_flux(out, jet::outlet_area(model));
}

void BM_field(benchmark::State& run) {
  Field f(saved(run));
  for (auto _ : run) {
    f.evaluate();
    benchmark::ClobberMemory();
  }
  run.counters["candidates"] = static_cast<double>(f.state.candidates.size());
  // All candidates, hidden or not, over what complete reflection of the whole jet would give.
  run.counters["force_over_2J"] = jet::jet_force(f.state, f.p.state.area_vector.map()).x() /
                                  (2.0 * jet::momentum_flux(f.out, jet::outlet_area(f.model)));
}

const bool kTreeAdded = jet::add_tree_route();

void BM_visibility(benchmark::State& run) {
  const auto route = static_cast<jet::VisibilityRoute>(run.range(1));
  const PassengerState& p = saved(run);
  const char* const names[] = {", fast", ", CGAL tree", ", brute force"};
  run.SetLabel(std::string(benchmarks::name_of(static_cast<Shape>(run.range(0)))) + names[run.range(1)]);
  const Field f(p);
  jet::VisibilityQuery query(p.bag.mesh.elements, p.model.node_count,
                             {p.null_elements, p.attachment_elements});
  std::vector<std::uint8_t> lit(f.state.candidates.size()), truth(lit.size());
  const auto source = jet::ray_source(f.model);
  jet::VisibilityCounters counters;
  for (auto _ : run) counters = query.query(route, p.state.position.map(), source, f.state.candidates, lit);
  query.query(jet::VisibilityRoute::brute_force, p.state.position.map(), source, f.state.candidates, truth);
  run.counters["lit"] = static_cast<double>(counters.lit);
  run.counters["hidden"] = static_cast<double>(counters.hidden);
  run.counters["facing_away"] = static_cast<double>(counters.facing_away);
  run.counters["exact_calls"] = static_cast<double>(counters.exact_calls);
  run.counters["fallbacks"] = static_cast<double>(counters.fallbacks);
  run.counters["differs"] = lit == truth ? 0.0 : 1.0;  // from brute force
}

BENCHMARK(BM_outlet);
BENCHMARK(BM_field)->DenseRange(0, benchmarks::kShapes - 1)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_visibility)->ArgsProduct({{0, 1, 2}, {0, 1, 2}})->Unit(benchmark::kMicrosecond);

}  // namespace
