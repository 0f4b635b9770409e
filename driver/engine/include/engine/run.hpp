// SPDX-License-Identifier: Apache-2.0
// A run: steps from 0 to the end of the scene.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "engine/level_loop.hpp"
#include "engine/scene.hpp"
#include "engine/state.hpp"

namespace driver {

/// inaccurate: it came to its end, but the energy drifted by more than a hundredth (K.21).
enum class RunStatus { done, inaccurate, interrupted, failed };

struct RunOutcome {
  RunStatus status = RunStatus::done;
  std::string message;             // of a failure: stage, time, limit; of an inaccurate run: drift, cause
  bool out_of_memory = false;      // is why it failed: no fault of the scene
  std::string warning;             // of a drift of the energy that is less, but more than a thousandth
  std::vector<std::string> notes;  // at the end of a run: what never came on, was held or left behind
  double wall_seconds = 0.0;
  /// [s] CPU time from the first step to the last, and of each stage; the rest of it are rows and files.
  double cpu_seconds = 0.0;
  std::array<double, kStages> stage_seconds{};
};

/// Steps the scene to its end or to an interrupt, calling `sink` after each step. Failures of the computation
/// (exit code 3) are reported in the outcome, not thrown. `stop` (empty: Ctrl-C) is asked before every step.
RunOutcome run_scene(const Scene& scene, State& state, const LevelSink& sink,
                     const std::vector<LevelView>& views = {}, const Executor& executor = Executor::serial(),
                     const std::function<bool()>& stop = {});

/// Adds notes and the judgement of the drift to the outcome of a run that was done, stopped or failed.
void conclude(const Scene& scene, const State& state, RunOutcome& outcome);

/// "done", "inaccurate", "interrupted" or "failed".
const char* status_name(RunStatus status);
}  // namespace driver
