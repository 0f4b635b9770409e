// SPDX-License-Identifier: Apache-2.0
// Inverse tank test against noise and number of readings: a known pulse (80 g in 50 ms into 60 litres, 800 K
// falling to 400 K) read over 60 ms, with Gaussian noise that is a fraction of the reading; mean time of one
// analysis with its default options and r.m.s. error over its unmasked points, both over several seeds.
// Average temperature is held to what it is exact for: the product mdot T_s and the mean temperature.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "closed_form/tank_test.hpp"
#include "tank_test/identify.hpp"

namespace {

constexpr double kEnd = 0.06, kMeanFlow = 1.6, kMeanTemperature = 600.0;  // [s], [kg/s], [K] by symmetry
constexpr int kSeeds = 8;

closed_form::TankTestReadings truth(double time) {
  return closed_form::tank_test_pulse({}, {}, {0.06, 101325.0, 293.15, 0.08, 0.05, 800.0, 400.0, 1e-4}, time);
}

gas::TankTest test() {
  return {gas::Thermo({gas::constant_cp_species("N2", 296.8, 1038.8)}), 0.06, 293.15, {1.0}, {1.0}, 0.08};
}

struct Record {
  std::vector<double> times, tank, chamber;
  Record(int readings, double noise, int seed) {
    std::mt19937_64 generator(static_cast<unsigned>(seed));
    std::normal_distribution<double> normal;
    for (int i = 0; i < readings; ++i) {
      times.push_back(kEnd * i / (readings - 1));
      const auto reading = truth(times.back());
      tank.push_back(reading.tank_pressure * (1.0 + noise * normal(generator)));
      chamber.push_back(reading.chamber_pressure * (1.0 + noise * normal(generator)));
    }
  }
};

/// Sums of squares of errors: of the flow relative to its mean, of the temperature relative to itself.
struct Squares {
  double flow = 0.0, temperature = 0.0;
  int points = 0;
};

void add(Squares& sum, const gas::Identified& found, bool dual) {
  for (const auto& point : found.points) {
    if (point.masked) continue;
    const auto exact = truth(point.time);
    const double flow = dual ? (point.mass_flow - exact.mass_flow) / kMeanFlow
                             : (point.mass_flow * point.temperature - exact.mass_flow * exact.temperature) /
                                   (kMeanFlow * kMeanTemperature);
    const double temperature =
        (dual ? point.temperature / exact.temperature : found.mean_temperature / kMeanTemperature) - 1.0;
    sum.flow += flow * flow;
    sum.temperature += temperature * temperature;
    ++sum.points;
  }
}

void run_identify(benchmark::State& run, bool dual, double noise, int readings) {
  std::vector<Record> records;
  for (int seed = 1; seed <= kSeeds; ++seed) records.emplace_back(readings, noise, seed);
  const gas::TankTest known = test();
  std::vector<gas::Identified> found(kSeeds);
  std::size_t next = 0;
  for (auto _ : run) {
    const Record& record = records[next % kSeeds];
    const std::span<const double> chamber =
        dual ? std::span<const double>(record.chamber) : std::span<const double>();
    found[next++ % kSeeds] = gas::identify(known, {record.times, record.tank, chamber});
  }
  Squares sum;
  for (const auto& one : found) add(sum, one, dual);
  run.counters["flow_error"] = std::sqrt(sum.flow / sum.points);
  run.counters["temperature_error"] = std::sqrt(sum.temperature / sum.points);
}

bool register_all() {
  const auto add_one = [](bool dual, int digits, int readings) {
    const std::string name = std::string(dual ? "dual" : "average") + "/1e-" + std::to_string(digits) + "/" +
                             std::to_string(readings);
    benchmark::RegisterBenchmark(name.c_str(), run_identify, dual, std::pow(10.0, -digits), readings)
        ->Iterations(kSeeds);
  };
  for (const bool dual : {false, true}) {
    for (int digits = 2; digits <= 6; ++digits) add_one(dual, digits, 601);
    for (const int digits : {2, 4})
      for (const int readings : {151, 301, 1201, 2401, 4801}) add_one(dual, digits, readings);
  }
  return true;
}

const bool registered = register_all();

}  // namespace
