// SPDX-License-Identifier: Apache-2.0
// Stages S1, S3, S8 and S9 of the bag, one thread unless a row says two. time_per_element counts all 2744
// elements; the other counters are the physics of the state and how well its identities hold.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "membrane/node_order.hpp"
#include "membrane/stages.hpp"
#include "membrane/time_step.hpp"
#include "passenger_states.hpp"

namespace {

using benchmarks::PassengerState;
using benchmarks::Shape;

const PassengerState& saved(benchmark::State& run) {
  const auto shape = static_cast<Shape>(run.range(0));
  run.SetLabel(benchmarks::name_of(shape));
  return benchmarks::passenger_state(shape);
}

void count_elements(benchmark::State& run, const PassengerState& p, double stages_per_round = 1.0) {
  run.counters["time_per_element"] =
      benchmark::Counter(stages_per_round * p.model.element_count,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void BM_surface(benchmark::State& run) {
  const PassengerState& p = saved(run);
  membrane::BagState state = p.state;
  for (auto _ : run) {
    membrane::update_surface(p.model, state);
    benchmark::ClobberMemory();
  }
  count_elements(run, p);
  const double volume = mesh::enclosed_volume(p.state.position.map(), p.bag.mesh.elements);
  run.counters["volume_litres"] = 1e3 * state.surface.volume;
  run.counters["volume_error"] = std::abs(state.surface.volume / volume - 1.0);
  // x . dV/dx = 3 V (M.5)
  const double gradient = state.position.map().cwiseProduct(state.volume_gradient.map()).sum();
  run.counters["gradient_error"] = std::abs(gradient / (3.0 * volume) - 1.0);
}

void BM_membrane_forces(benchmark::State& run) {
  const PassengerState& p = saved(run);
  membrane::BagState state = p.state;
  for (auto _ : run) {
    membrane::membrane_forces(p.model, state);
    benchmark::ClobberMemory();
  }
  count_elements(run, p);
  const auto f = state.membrane_force.map();
  run.counters["strain_energy_J"] = state.forces.strain_energy;
  run.counters["force_sum_error"] = f.rowwise().sum().norm() / f.colwise().norm().sum();
}

void BM_support_and_pressure_forces(benchmark::State& run) {
  const PassengerState& p = saved(run);
  membrane::BagState state = p.state;
  for (auto _ : run) {
    membrane::support_forces(p.model, state);
    membrane::pressure_forces(state, p.gauge_pressure);
    benchmark::ClobberMemory();
  }
  count_elements(run, p);
  run.counters["strap_N"] = state.strap_tension.front();
}

void BM_jet_forces(benchmark::State& run) {
  const PassengerState& p = saved(run);
  membrane::BagState state = p.state;
  const std::vector<double> overpressure(static_cast<std::size_t>(p.model.element_count), 1e3);  // [Pa]
  for (auto _ : run) {
    membrane::update_geometry(p.model, state);
    membrane::jet_forces(p.model, state, overpressure);
    benchmark::ClobberMemory();
  }
  count_elements(run, p);
  // Uniform overpressure: 1 kPa times dV/dx.
  const auto exact = 1e3 * state.volume_gradient.map();
  run.counters["force_error"] = (state.jet_force.map() - exact).norm() / exact.norm();
}

void BM_critical_step(benchmark::State& run) {
  const PassengerState& p = saved(run);
  double step = 0.0;
  for (auto _ : run) {
    step = membrane::critical_time_step(membrane::stiffness_shares(
        p.model, p.state, benchmarks::kGamma, benchmarks::kAmbientPressure + p.gauge_pressure));
    benchmark::ClobberMemory();
  }
  run.counters["step_us"] = 1e6 * step;
}

// The saved state is restored every kRounds advances: positions stay near it, and copying it is not timed.
void BM_advance(benchmark::State& run) {
  constexpr int kRounds = 64;
  const PassengerState& p = saved(run);
  membrane::BagState state = p.state;
  double worst = 0.0;
  for (auto _ : run) {
    run.PauseTiming();
    state.position = p.state.position;
    state.velocity = p.state.velocity;
    run.ResumeTiming();
    for (int i = 0; i < kRounds; ++i) membrane::advance(p.model, state, 1e-6, 1e-6);
    const auto& sums = state.advance;
    const double gap = sums.kinetic_after - sums.kinetic_before - sums.work.total();
    worst = std::max(worst, std::abs(gap) / (std::abs(sums.work.total()) + sums.kinetic_after));
  }
  count_elements(run, p, kRounds);
  run.counters["ledger_error"] = worst;  // kick form
}

// One step of the bag under constant gauge pressure: S9 with the fabric of S3, supports and pressure, S8.
template <class ForEachBlock = membrane::Serial>
void one_step(const membrane::BagModel& model, membrane::BagState& state, double gauge_pressure,
              const ForEachBlock& for_each_block = {}) {
  membrane::update_skin(model, state, for_each_block);
  membrane::support_forces(model, state, for_each_block);
  membrane::pressure_forces(state, gauge_pressure);
  membrane::advance(model, state, 1e-7, 1e-7, for_each_block);
}

void BM_bag_step(benchmark::State& run) {
  constexpr int kRounds = 16;
  const PassengerState& p = saved(run);
  membrane::BagState state = p.state;
  for (auto _ : run) {
    run.PauseTiming();
    state.position = p.state.position;
    state.velocity = p.state.velocity;
    run.ResumeTiming();
    for (int i = 0; i < kRounds; ++i) one_step(p.model, state, p.gauge_pressure);
  }
  count_elements(run, p, kRounds);
  run.counters["volume_litres"] = 1e3 * state.surface.volume;
}

// Torus of radii 1 m and 0.3 m of 2 around x across elements, its nodes ordered as the program orders them.
mesh::Mesh torus(int around, int across) {
  const double turn = 2.0 * std::numbers::pi;
  mesh::Mesh mesh;
  mesh.nodes.resize(3, around * across);
  mesh.elements.resize(3, 2 * around * across);
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = turn * i / around, v = turn * j / across, r = 1.0 + 0.3 * std::cos(v);
      const int a = i * across + j, d = i * across + (j + 1) % across;
      const int b = (i + 1) % around * across + j, c = (i + 1) % around * across + (j + 1) % across;
      mesh.nodes.col(a) << r * std::cos(u), r * std::sin(u), 0.3 * std::sin(v);
      mesh.elements.col(2 * a) << a, b, c;
      mesh.elements.col(2 * a + 1) << a, c, d;
    }
  return mesh.element_count() > membrane::kCachedElements
             ? renumbered(mesh, membrane::node_order(mesh.elements, mesh.node_count()))
             : mesh;
}

struct Blocks {
  bool parallel;
  template <class F>
  void operator()(int count, F&& f) const {
    if (parallel)
      tbb::parallel_for(0, count, f);
    else
      membrane::Serial{}(count, f);
  }
};

membrane::BagModel torus_model(const mesh::Mesh& mesh, membrane::Isa isa, bool woven) {
  membrane::BagDescription bag;
  bag.reference = mesh.nodes;
  bag.elements = mesh.elements;
  bag.isa = isa;
  membrane::ElementProperties fabric{0.5e-3, 620.0, 60e6, 0.3, 0.05, false};
  if (woven) fabric.weave = {45e6, 2e6, {0.3, 0.2, 1.0}};
  bag.properties.assign(static_cast<std::size_t>(mesh.element_count()), fabric);
  return make_model(bag);
}

// The same step on meshes that fit the second-level cache (0), the third (1), or none (2). Every array of the
// step is read or written once: bytes_per_second of it, to be held against that of BM_copy.
void BM_torus_step(benchmark::State& run) {
  constexpr int size[3][2] = {{49, 28}, {400, 125}, {1250, 400}};
  const auto isa = static_cast<membrane::Isa>(run.range(1));
  const auto threads = static_cast<std::size_t>(run.range(2));
  const bool woven = run.range(3) != 0;
  run.SetLabel(std::string(membrane::name_of(isa)) + (woven ? ", woven" : ""));
  const auto mesh = torus(size[run.range(0)][0], size[run.range(0)][1]);
  const auto model = torus_model(mesh, isa, woven);
  auto state = membrane::make_state(model, 1.02 * mesh.nodes);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  for (auto _ : run) one_step(model, state, 1e3, Blocks{threads > 1});
  run.counters["elements"] = mesh.element_count();
  run.counters["time_per_element"] = benchmark::Counter(
      mesh.element_count(), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  run.counters["volume_m3"] = state.surface.volume;  // 2 pi^2 R r^2 1.02^3 = 1.885 less the facets
  // A group of four elements, and of each node: x, v, f and g of 32 bytes with 5 reads and 4 writes, mass.
  const auto element_bytes = static_cast<double>(
      model.elements.group.size() * (sizeof(membrane::ElementGroup) + sizeof(membrane::FrequencyGroup)) +
      model.elements.fabric.size() * sizeof(membrane::FabricGroup));
  const double node_bytes = model.node_count * (9.0 * 32.0 + 3.0 * 8.0);
  run.counters["element_bytes"] = element_bytes / mesh.element_count();  // per element, as the next
  run.counters["node_bytes"] = node_bytes / mesh.element_count();
  run.SetBytesProcessed(run.iterations() * static_cast<std::int64_t>(element_bytes + node_bytes));
}

// Copy of as many MB as given: what the memory gives, reads and writes together.
void BM_copy(benchmark::State& run) {
  const auto count = static_cast<std::size_t>(run.range(0)) * 1000 * 1000 / sizeof(double);
  const std::vector<double> from(count, 1.0);
  std::vector<double> to(count, 0.0);
  for (auto _ : run) {
    std::copy(from.begin(), from.end(), to.begin());
    benchmark::ClobberMemory();
  }
  run.SetBytesProcessed(run.iterations() * static_cast<std::int64_t>(2 * count * sizeof(double)));
}

void torus_rows(benchmark::internal::Benchmark* b) {
  const auto best = static_cast<int>(membrane::best_isa());
  for (const int mesh : {0, 1, 2}) {
    b->Args({mesh, static_cast<int>(membrane::Isa::baseline), 1, 0});
    for (const int threads : {1, 2}) b->Args({mesh, best, threads, 0});
    b->Args({mesh, best, 1, 1});
  }
  b->ArgNames({"mesh", "isa", "threads", "woven"})->UseRealTime()->Unit(benchmark::kMillisecond);
}

void shapes(benchmark::internal::Benchmark* b) {
  b->DenseRange(0, benchmarks::kShapes - 1)->Unit(benchmark::kMicrosecond);
}
BENCHMARK(BM_surface)->Apply(shapes);
BENCHMARK(BM_membrane_forces)->Apply(shapes);
BENCHMARK(BM_support_and_pressure_forces)->Apply(shapes);
BENCHMARK(BM_jet_forces)->Apply(shapes);
BENCHMARK(BM_critical_step)->Apply(shapes);
BENCHMARK(BM_advance)->Apply(shapes);
BENCHMARK(BM_bag_step)->Apply(shapes);
BENCHMARK(BM_torus_step)->Apply(torus_rows);
BENCHMARK(BM_copy)->Arg(15)->Arg(150)->Unit(benchmark::kMillisecond);

}  // namespace
