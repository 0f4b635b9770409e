// SPDX-License-Identifier: Apache-2.0
// Stages S2 and S10: temperature from internal energy, the gas point, one step of the filling and venting
// bag.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numeric>
#include <utility>

#include "gas/control_volume.hpp"
#include "gas/integrator.hpp"

namespace {

constexpr double kVolume = 0.1, kVolumeAfter = 0.1005, kLeakArea = 1.5 * 0.05 * 0.05;  // [m3], [m2]
constexpr double kTime = 0.02, kStep = 2e-5;                                           // [s]

// 0: nitrogen of constant cp alone. 1: nitrogen of cp(T). 2: nitrogen that enters four gases of air, cp(T).
gas::Thermo thermo(int kind) {
  if (kind == 0) return gas::Thermo({gas::constant_cp_species("N2", 296.8, 1038.8)});
  if (kind == 1) return gas::Thermo({gas::nasa7_species("N2")});
  return gas::Thermo({gas::nasa7_species("N2"), gas::nasa7_species("O2"), gas::nasa7_species("Ar"),
                      gas::nasa7_species("CO2")});
}
const char* const kLabels[] = {"N2, constant cp", "N2, cp(T)", "N2 into air, cp(T)"};

std::vector<double> first_only(const gas::Thermo& t) {
  std::vector<double> fractions(t.size(), 0.0);
  fractions[0] = 1.0;
  return fractions;
}

// The bag of the pendulum scene at 20 ms: 4 kg/s falling, one vent, porous fabric.
gas::ControlVolumeModel bag(int kind) {
  gas::ControlVolumeModel model{thermo(kind), {101325.0, 293.15}, {}, {{0.6, 2e-3}}};
  model.inflows.push_back({first_only(model.thermo),
                           gas::Curve({{0.0, 0.0}, {0.012, 4.0}, {0.08, 0.0}}, gas::Outside::zero),
                           gas::Curve::constant(406.0)});
  return model;
}

gas::ControlVolumeState saved(const gas::ControlVolumeModel& model, double pressure) {
  const auto fractions = model.thermo.size() == 4 ? model.thermo.mass_fractions_by_mole(gas::air_by_mole())
                                                  : first_only(model.thermo);
  return gas::make_state(model.thermo, fractions, pressure, 380.0, kVolume);
}

void BM_temperature_from_energy(benchmark::State& run) {
  const int kind = static_cast<int>(run.range(0));
  run.SetLabel(kLabels[kind]);
  const gas::Thermo t = thermo(kind);
  const gas::Mixture mixture = t.mixture(first_only(t));
  // Temperatures 0.2 K apart, as one step changes them, each the guess of the next.
  std::vector<double> energies;
  for (int i = 0; i < 1000; ++i) energies.push_back(mixture.internal_energy(380.0 + 0.2 * i));
  double worst = 0.0;
  for (auto _ : run) {
    double guess = 380.0;
    for (const double u : energies) guess = mixture.temperature(u, guess);
    benchmark::DoNotOptimize(std::as_const(guess));
  }
  double guess = 380.0;
  for (int i = 0; i < 1000; ++i) {
    guess = mixture.temperature(energies[static_cast<std::size_t>(i)], guess);
    worst = std::max(worst, std::abs(guess - (380.0 + 0.2 * i)));
  }
  run.counters["time_per_call"] =
      benchmark::Counter(1000.0, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  run.counters["error_K"] = worst;
}

// Cold: states from 250 to 5900 K in an order without neighbours, each from the same guess.
void BM_temperature_cold(benchmark::State& run) {
  const int kind = static_cast<int>(run.range(0));
  run.SetLabel(kLabels[kind]);
  const gas::Thermo t = thermo(kind);
  const gas::Mixture mixture = t.mixture(first_only(t));
  constexpr int kStates = 1000, kStride = 377;  // coprime
  std::vector<double> temperatures, energies;
  for (int i = 0; i < kStates; ++i) {
    temperatures.push_back(250.0 + 5.65 * (i * kStride % kStates));
    energies.push_back(mixture.internal_energy(temperatures.back()));
  }
  double worst = 0.0;
  for (std::size_t i = 0; i < energies.size(); ++i)
    worst = std::max(worst, std::abs(mixture.temperature(energies[i], 300.0) - temperatures[i]));
  for (auto _ : run)
    for (const double u : energies) benchmark::DoNotOptimize(mixture.temperature(u, 300.0));
  run.counters["time_per_call"] = benchmark::Counter(
      kStates, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  run.counters["error_K"] = worst;
}

void BM_gas_point(benchmark::State& run) {
  const int kind = static_cast<int>(run.range(0));
  run.SetLabel(kLabels[kind]);
  const auto model = bag(kind);
  const auto state = saved(model, 120e3);
  gas::GasPoint point{};
  for (auto _ : run) {
    point = gas::evaluate(model, state, kVolume, kLeakArea, kTime);
    benchmark::DoNotOptimize(std::as_const(point));
  }
  run.counters["pressure_error"] = std::abs(point.pressure / 120e3 - 1.0);
  run.counters["vent_kg_s"] = point.vent_mass_flow;
  run.counters["fabric_kg_s"] = point.fabric_mass_flow;
}

// One step from the saved state; the error counters are the residuals of the step's own books.
void BM_gas_advance(benchmark::State& run) {
  const int kind = static_cast<int>(run.range(0));
  const bool choked = run.range(1) != 0;
  run.SetLabel(std::string(kLabels[kind]) + (choked ? ", choked" : ", subsonic"));
  const auto model = bag(kind);
  gas::GasIntegrator integrator(model);
  const auto before = saved(model, choked ? 300e3 : 120e3);
  auto state = before;
  gas::StepFluxes flux{};
  for (auto _ : run) {
    state = before;  // sizes agree: copies, allocates nothing
    flux = integrator.advance(state, kTime, kTime + kStep, {kVolume, kVolumeAfter, kLeakArea, kLeakArea});
    benchmark::DoNotOptimize(std::as_const(flux));
  }
  const auto total = [](const gas::ControlVolumeState& s) {
    return std::accumulate(s.masses.begin(), s.masses.end(), 0.0);
  };
  const double mass = total(state) - total(before) - flux.mass_in + flux.vent_mass_out + flux.fabric_mass_out;
  const double energy =
      state.internal_energy - before.internal_energy - flux.enthalpy_in + flux.enthalpy_out + flux.work;
  run.counters["mass_residual"] = std::abs(mass) / total(before);
  run.counters["energy_residual"] = std::abs(energy / before.internal_energy);
  run.counters["substeps"] = flux.steps;
  run.counters["evaluations"] = flux.evaluations;
}

BENCHMARK(BM_temperature_from_energy)->DenseRange(0, 2);
BENCHMARK(BM_temperature_cold)->DenseRange(0, 2);
BENCHMARK(BM_gas_point)->DenseRange(0, 2);
BENCHMARK(BM_gas_advance)->ArgsProduct({{0, 1, 2}, {0, 1}});

}  // namespace
