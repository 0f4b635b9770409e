// SPDX-License-Identifier: Apache-2.0
// The 60-litre tank of air, cp(T), filled with N2, CO2, H2O at 1200 K for 50 ms and held to 100 ms: sealed, and with a
// vent of 1e-3 m2, by each method, by GSL's msbdf and, if installed, by SUNDIALS CVODE. Each prints the error it achieved
// in p and T, against a run at 1e-13.
#include <benchmark/benchmark.h>

#include <cmath>
#include <utility>

#include "gas_peers.hpp"
#include "second_route.hpp"

namespace {

using second_route::kEnd;
using second_route::kVolume;
using second_route::VentedTank;

constexpr gas::VolumePath kRigid{kVolume, kVolume, 0.0, 0.0};

const VentedTank& tank(bool vented) {
  static const VentedTank with = second_route::benchmark_tank(), without = second_route::benchmark_tank(0.0);
  return vented ? with : without;
}

/// Larger of the relative errors of p and T at the end.
double achieved_error(const VentedTank& t, const gas::ControlVolumeState& state) {
  static const auto reference = [](const VentedTank& exact) {
    gas::ControlVolumeState end = exact.start;
    gas::GasIntegrator(exact.model, {1e-13}).advance(end, 0.0, kEnd, kRigid);
    return gas::evaluate(exact.model, end, kVolume, 0.0, kEnd);
  };
  const gas::GasPoint exact = reference(t), point = gas::evaluate(t.model, state, kVolume, 0.0, kEnd);
  return std::max(std::abs(point.pressure / exact.pressure - 1.0),
                  std::abs(point.temperature / exact.temperature - 1.0));
}

void run_integrator(benchmark::State& run, const VentedTank& t, const gas::IntegratorOptions& options) {
  gas::GasIntegrator integrator(t.model, options);
  gas::ControlVolumeState state = t.start;
  gas::StepFluxes fluxes{};
  for (auto _ : run) {
    state = t.start;
    fluxes = integrator.advance(state, 0.0, kEnd, kRigid);
    benchmark::DoNotOptimize(std::as_const(state.internal_energy));
  }
  run.counters["error"] = achieved_error(t, state);
  run.counters["substeps"] = fluxes.steps;
  run.counters["evaluations"] = fluxes.evaluations;
}

double tolerance(const benchmark::State& run, int argument) {
  return std::pow(10.0, -static_cast<double>(run.range(argument)));
}

void BM_tank_sealed(benchmark::State& run) {
  run_integrator(run, tank(false), {});
  // Against the balance itself: U = U0 + int mdot h, which quadrature has to round-off.
  const VentedTank& t = tank(false);
  const double expected =
      t.start.internal_energy +
      second_route::kFilled * t.model.thermo.enthalpy(t.model.inflows[0].mass_fractions, 1200.0);
  gas::ControlVolumeState end = t.start;
  gas::GasIntegrator(t.model).advance(end, 0.0, kEnd, kRigid);
  run.counters["error"] = std::abs(end.internal_energy / expected - 1.0);
}

void BM_tank_vented(benchmark::State& run) {
  const auto method = static_cast<gas::Method>(run.range(0));
  run.SetLabel(std::vector{"dormand_prince", "runge_kutta", "euler", "rosenbrock"}[static_cast<std::size_t>(method)]);
  run_integrator(run, tank(true), {tolerance(run, 1), 100000000, method});
}

template <gas::ControlVolumeState (*Peer)(const VentedTank&, double)>
void run_peer(benchmark::State& run, const char* name) {
  run.SetLabel(name);
  gas::ControlVolumeState end;
  for (auto _ : run) benchmark::DoNotOptimize(end = Peer(tank(true), tolerance(run, 0)));
  run.counters["error"] = achieved_error(tank(true), end);
}

void BM_tank_vented_msbdf(benchmark::State& run) {
  run_peer<second_route::msbdf>(run, "msbdf");
}

BENCHMARK(BM_tank_sealed);
BENCHMARK(BM_tank_vented)->ArgsProduct({{0, 1, 3}, {4, 5, 6, 7, 8, 9, 10, 11}});
BENCHMARK(BM_tank_vented)->ArgsProduct({{2}, {4, 5, 6, 7}});
BENCHMARK(BM_tank_vented_msbdf)->DenseRange(5, 11);

#ifdef GASJET_CVODE
void BM_tank_vented_cvode(benchmark::State& run) {
  run_peer<peers::cvode>(run, "cvode");
}
BENCHMARK(BM_tank_vented_cvode)->DenseRange(5, 11);
#endif

}  // namespace
