// SPDX-License-Identifier: Apache-2.0
// Whole runs of the paper's scene: what a step costs, and what the jet adds to it. One thread.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "driver/results.hpp"
#include "driver/run.hpp"
#include "jet_tree/tree_route.hpp"

namespace {

using driver::Stage;

double seconds_of(const driver::State& state, Stage stage) {
  return state.stage_seconds[static_cast<std::size_t>(stage)];
}

double total_seconds(const driver::State& state) {
  double sum = 0.0;
  for (const double s : state.stage_seconds) sum += s;
  return sum;
}

// Physics beside the time: a fast run that is wrong shows it in the same line.
void report(benchmark::State& bench, const driver::Scene& scene, const driver::State& state, double seconds,
            double jet_seconds, double steps, double blowing) {
  bench.counters["us_per_step"] = 1e6 * seconds / steps;
  bench.counters["ns_per_element"] = 1e9 * seconds / steps / scene.bag->model.element_count;
  bench.counters["jet_us_per_step"] = 1e6 * jet_seconds / steps;
  bench.counters["jet_us_while_blowing"] = 1e6 * jet_seconds / std::max(blowing, 1.0);
  bench.counters["steps"] = static_cast<double>(state.steps);
  bench.counters["drift_rel"] = state.peaks.energy_residual / state.flows.enthalpy_in;
  bench.counters["angle_rad"] = state.level.pendulum_angle;
  // The CSV reporter wants the same counters of all cases.
  const auto total = state.jets.empty() ? jet::VisibilityCounters{} : state.jets.front().total;
  bench.counters["hidden_per_step"] = static_cast<double>(total.hidden) / static_cast<double>(state.steps);
  bench.counters["exact_calls"] = static_cast<double>(total.exact_calls);
}

// Time of S7 and of all stages up to first contact: what the search costs while nothing touches.
struct Untouched {
  double contact = 0.0, all = 0.0;  // [s]
  void update(const driver::State& state) {
    if (state.peaks.first_contact >= 0.0) return;
    contact = seconds_of(state, Stage::contact);
    all = total_seconds(state);
  }
};

void run_case(benchmark::State& bench, const std::string& name, const std::vector<std::string>& overrides) {
  driver::CaseDocument document(std::string(GASJET_SOURCE_DIR "/cases/") + name + ".toml", overrides);
  const driver::Scene scene = driver::read_scene(document);
  double seconds = 0.0, jet_seconds = 0.0, steps = 0.0, blowing = 0.0;
  for (auto iteration : bench) {
    driver::State state = driver::make_state(scene);
    Untouched untouched;
    const auto outcome = driver::run_scene(scene, state, [&](bool, const driver::State& now) {
      untouched.update(now);
      blowing += !now.jets.empty() && now.jets.front().outlet.density > 0.0;
    });
    if (outcome.status != driver::RunStatus::done) {
      bench.SkipWithError(outcome.message.c_str());
      return;
    }
    bench.SetIterationTime(total_seconds(state));
    seconds += total_seconds(state);
    jet_seconds += seconds_of(state, Stage::outlet) + seconds_of(state, Stage::jet_field) +
                   seconds_of(state, Stage::visibility);
    steps += static_cast<double>(state.steps);
    report(bench, scene, state, seconds, jet_seconds, steps, blowing);
    bench.counters["untouched_contact_percent"] = 100.0 * untouched.contact / untouched.all;
  }
}

}  // namespace

int main(int argc, char** argv) {
  jet::add_tree_route();
  for (const auto& [key, value] : driver::provenance("cases/passenger_pendulum.toml", {}))
    if (key != "case" && key != "options") benchmark::AddCustomContext(key, value);
  const auto add = [](const char* label, const std::string& name, std::vector<std::string> overrides) {
    benchmark::RegisterBenchmark(label, [=](benchmark::State& bench) { run_case(bench, name, overrides); })
        ->UseManualTime()
        ->ComputeStatistics("least",
                            [](const auto& runs) { return *std::min_element(runs.begin(), runs.end()); })
        ->Unit(benchmark::kMillisecond);
  };
  add("no_jet", "passenger_pendulum_no_jet", {});
  add("jet_no_occlusion", "passenger_pendulum", {"inflator.0.jet.occlusion=false"});
  add("jet_fast", "passenger_pendulum", {"inflator.0.jet.visibility=fast"});
  add("jet_cgal_tree", "passenger_pendulum", {"inflator.0.jet.visibility=cgal_tree"});
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
