// SPDX-License-Identifier: Apache-2.0
// Work against precision of the gas: each tank of gas_problems.hpp at tolerances from 1e-2 to 1e-12 by each
// method, by GSL's msbdf and, if installed, by SUNDIALS CVODE. Each prints the error that it achieved in p
// and T beside its time: against the closed form, or else against a run by another method, Rosenbrock 4 at
// 1e-12 for Dormand-Prince, which is the reference at 1e-13 of all others.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "gas_peers.hpp"
#include "gas_problems.hpp"

namespace {

using benchmarks::GasProblem;
using benchmarks::PressureTemperature;
using gas::Method;
using States = std::vector<gas::ControlVolumeState>;  // one for each observed time
using Reference = std::vector<PressureTemperature>;

constexpr int kMostSteps = 100000000;

struct Work {
  int steps = 0, evaluations = 0;
};

/// The states keep their size: nothing is allocated.
Work integrate(const GasProblem& problem, gas::GasIntegrator& integrator, States& states) {
  const second_route::Tank& tank = problem.tank;
  Work work;
  for (std::size_t i = 0; i < states.size(); ++i) {
    states[i] = i == 0 ? tank.start : states[i - 1];
    const gas::StepFluxes fluxes =
        integrator.advance(states[i], i == 0 ? 0.0 : problem.observed[i - 1], problem.observed[i],
                           {tank.volume, tank.volume, tank.leak_area, tank.leak_area});
    work.steps += fluxes.steps;
    work.evaluations += fluxes.evaluations;
  }
  return work;
}

Reference compute_reference(const GasProblem& problem, Method method) {
  States states(problem.observed.size(), problem.tank.start);
  if (!problem.exact) {
    const double tolerance = method == Method::rosenbrock_4 ? 1e-12 : 1e-13;
    gas::GasIntegrator integrator(problem.tank.model, {tolerance, kMostSteps, method});
    integrate(problem, integrator, states);
  }
  Reference reference;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const double time = problem.observed[i];
    reference.push_back(problem.exact ? problem.exact(time)
                                      : benchmarks::observe(problem.tank, states[i], time));
  }
  return reference;
}

const Reference& reference(const GasProblem& problem, Method method) {
  static std::map<std::pair<std::string, Method>, Reference> known;
  const auto [place, is_new] = known.try_emplace({problem.name, method});
  if (is_new) place->second = compute_reference(problem, method);
  return place->second;
}

/// Largest relative error of p and T over the observed times.
double achieved_error(const GasProblem& problem, const Reference& exact, const States& states) {
  double error = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const auto found = benchmarks::observe(problem.tank, states[i], problem.observed[i]);
    const double below = problem.of_overpressure ? problem.tank.model.ambient.pressure : 0.0;
    error = std::max({error, std::abs(found.pressure - exact[i].pressure) / (exact[i].pressure - below),
                      std::abs(found.temperature / exact[i].temperature - 1.0)});
  }
  return error;
}

/// A method that took this many evaluations at one tolerance is not tried at the next.
constexpr int kMostEvaluations = 300000;

void run_method(benchmark::State& run, const GasProblem& problem, Method method, double tolerance) {
  static std::map<std::pair<std::string, Method>, std::pair<double, int>> last;  // tolerance, evaluations
  const auto before = last.find({problem.name, method});
  if (before != last.end() && before->second.first > tolerance && before->second.second > kMostEvaluations)
    return run.SkipWithError("too many evaluations at the tolerance before");
  gas::GasIntegrator integrator(problem.tank.model, {tolerance, kMostSteps, method});
  States states(problem.observed.size(), problem.tank.start);
  Work work;
  for (auto _ : run) {
    work = integrate(problem, integrator, states);
    benchmark::DoNotOptimize(states.data());
    benchmark::ClobberMemory();
  }
  const Method other = method == Method::dormand_prince_5 ? Method::rosenbrock_4 : Method::dormand_prince_5;
  run.counters["error"] = achieved_error(problem, reference(problem, other), states);
  run.counters["substeps"] = work.steps;
  run.counters["evaluations"] = work.evaluations;
  last[{problem.name, method}] = {tolerance, work.evaluations};
}

using Peer = States (*)(const second_route::Tank&, double);

void run_peer(benchmark::State& run, const GasProblem& problem, Peer peer, double tolerance) {
  States all;
  try {
    for (auto _ : run) benchmark::DoNotOptimize(all = peer(problem.tank, tolerance));
  } catch (const std::runtime_error& failure) {
    return run.SkipWithError(failure.what());
  }
  States states;
  const auto& stops = problem.tank.stops;
  for (const double time : problem.observed)
    states.push_back(
        all[static_cast<std::size_t>(std::find(stops.begin(), stops.end(), time) - stops.begin())]);
  run.counters["error"] = achieved_error(problem, reference(problem, Method::dormand_prince_5), states);
  run.counters["substeps"] = 0;  // of our own alone
  run.counters["evaluations"] = 0;
}

bool register_all() {
  static const std::vector<GasProblem> problems = benchmarks::gas_problems();
  const std::pair<const char*, Method> methods[] = {{"dormand_prince", Method::dormand_prince_5},
                                                    {"runge_kutta", Method::runge_kutta_4},
                                                    {"euler", Method::euler},
                                                    {"rosenbrock", Method::rosenbrock_4}};
  const std::pair<const char*, Peer> peers[] = {
      {"msbdf",
       [](const second_route::Tank& tank, double tolerance) { return second_route::msbdf(tank, tolerance); }},
#ifdef GASJET_CVODE
      {"cvode", peers::cvode},
#endif
  };
  for (const GasProblem& problem : problems)
    for (int digits = 2; digits <= 12; ++digits) {
      const double tolerance = std::pow(10.0, -digits);
      const auto name = [&](const char* solver) {
        return problem.name + "/" + solver + "/1e-" + (digits < 10 ? "0" : "") + std::to_string(digits);
      };
      for (const auto& [solver, method] : methods)
        benchmark::RegisterBenchmark(name(solver).c_str(), run_method, problem, method, tolerance);
      for (const auto& [solver, peer] : peers)
        benchmark::RegisterBenchmark(name(solver).c_str(), run_peer, problem, peer, tolerance);
    }
  return true;
}

const bool registered = register_all();

}  // namespace
