// SPDX-License-Identifier: Apache-2.0
// A run: steps from 0 to the end of the scene.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "engine/scene.hpp"
#include "engine/schedule.hpp"
#include "engine/state.hpp"
#include "engine/step.hpp"

namespace driver {

/// inaccurate: it came to its end, but the energy drifted by more than a hundredth (K.21).
enum class RunStatus { done, inaccurate, interrupted, failed };

/// Called after every step; `recorded`: the columns (columns.hpp) may be read.
using LevelSink = std::function<void(bool recorded, const State&)>;

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

/// A view of a run: `show` is called at the levels that are `due`, when their forces stand. `due` is asked
/// once for each level; `last`: the run ends there.
struct LevelView {
  std::function<bool(const State&, bool last)> due;
  std::function<void(const State&)> show;
};

/// A view of the first level at or past each multiple of `interval` [s]; of none if that is 0.
LevelView at_multiples(double interval, std::function<void(const State&)> show);

/// Steps the scene to its end or to an interrupt, calling `sink` after each step. Failures of the computation
/// (exit code 3) are reported in the outcome, not thrown. `stop` (empty: Ctrl-C) is asked before every step.
RunOutcome run_scene(const Scene& scene, State& state, const LevelSink& sink,
                     const std::vector<LevelView>& views = {}, const Executor& executor = Executor::serial(),
                     const std::function<bool()>& stop = {});

/// "done", "inaccurate", "interrupted" or "failed".
const char* status_name(RunStatus status);
}  // namespace driver
