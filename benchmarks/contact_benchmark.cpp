// SPDX-License-Identifier: Apache-2.0
// Stage S4: the pendulum's impactor in front of and in the inflated passenger bag. The skin shifts to and fro
// by 1 mm a call, as a bag at 25 m/s does in 40 us.
#include <benchmark/benchmark.h>

#include <string>
#include <utility>

#include "coupling/pendulum.hpp"
#include "coupling/side.hpp"
#include "coupling/sphere_contact.hpp"
#include "passenger_states.hpp"

namespace {

constexpr double kRadius = 0.041, kEffectiveMass = 8.41, kStiffness = 2e8;  // [m], [kg], [N/m3]
constexpr double kShift = 1e-3;                                             // [m]
// Gap between the sphere and the bag's front, in radii; negative: penetration.
constexpr double kGaps[] = {20.0, 2.0, 0.2, -0.1, -0.3};

struct Scene {
  const benchmarks::PassengerState& p = benchmarks::passenger_state(benchmarks::Shape::inflated);
  coupling::ContactModel model{p.bag.mesh.elements,
                               p.bag.mesh.nodes,
                               p.model.node_mass,
                               kEffectiveMass,
                               {coupling::Sphere{kRadius}, kStiffness}};
  coupling::ContactState work = model.make_state();
  membrane::Vectors forces{p.model.node_count}, shifted = p.state.position;
  Eigen::Vector3d centre;

  explicit Scene(double gap) {
    shifted.map().row(0).array() += kShift;
    const auto here = p.state.position.map();
    Eigen::Index front = 0;
    here.row(0).maxCoeff(&front);
    centre = here.col(front) + Eigen::Vector3d(kShift + kRadius * (1.0 + gap), 0.0, 0.0);
  }
  // As the driver does it: first the question whether anything can touch, the skin having moved by kShift.
  coupling::ContactResult evaluate(bool shift) {
    if (model.stays_clear(work, kShift)) return {};
    const membrane::Vectors& position = shift ? shifted : p.state.position;
    return model.evaluate(work, position.map(), {centre}, forces.map());
  }
};

void BM_contact(benchmark::State& run) {
  const double gap = kGaps[run.range(0)];
  Scene scene(gap);
  run.SetLabel(gap > 0.0 ? "gap " + std::to_string(gap) + " r" : "depth " + std::to_string(-gap) + " r");
  bool shift = false;
  for (auto _ : run) {
    shift = !shift;
    const auto result = scene.evaluate(shift);
    benchmark::DoNotOptimize(result);
  }
  const int looks = scene.work.looks, skips = scene.work.skips;
  scene.forces.map().setZero();
  const auto result = scene.evaluate(true);
  const double force = result.force.norm();
  run.counters["force_N"] = force;
  run.counters["area_cm2"] = 1e4 * result.area;
  run.counters["depth_mm"] = 1e3 * result.penetration;
  run.counters["reaction_error"] =
      force > 0.0 ? (scene.forces.map().rowwise().sum() + result.force).norm() / force : 0.0;
  run.counters["looks_per_step"] = looks / static_cast<double>(run.iterations());
  run.counters["skips_per_step"] = skips / static_cast<double>(run.iterations());
  run.counters["sweeps"] = scene.work.sweeps;
}

void BM_winding_number(benchmark::State& run) {
  const Scene scene(1.0);
  double winding = 0.0;
  for (auto _ : run) {
    winding = coupling::winding_number(scene.p.bag.mesh.elements, scene.p.state.position.map(), scene.centre);
    benchmark::DoNotOptimize(std::as_const(winding));
  }
  run.counters["winding_error"] = std::abs(winding);  // outside
}

void BM_smallest_gap(benchmark::State& run) {
  const Scene scene(1.0);
  coupling::Gap gap;
  for (auto _ : run) {
    gap = coupling::smallest_gap(scene.p.bag.mesh.elements, scene.p.state.position.map(),
                                 coupling::Sphere{kRadius}, {scene.centre});
    benchmark::DoNotOptimize(std::as_const(gap));
  }
  run.counters["gap_mm"] = 1e3 * gap.distance;
}

BENCHMARK(BM_contact)->DenseRange(0, 4)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_winding_number)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_smallest_gap)->Unit(benchmark::kMicrosecond);

}  // namespace
