// SPDX-License-Identifier: Apache-2.0
// A run: steps from 0 to the end of the scene, with its result files.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "driver/crossing.hpp"
#include "driver/results.hpp"
#include "driver/scene.hpp"
#include "driver/state.hpp"
#include "driver/step.hpp"

namespace driver {

class CaseDocument;

/// inaccurate: it came to its end, but the energy drifted by more than a hundredth (K.21).
enum class RunStatus { done, inaccurate, interrupted, failed };

/// Called after every step; `recorded`: the columns (columns.hpp) may be read.
using LevelSink = std::function<void(bool recorded, const State&)>;

struct RunOptions {
  bool quiet = false;
  int threads = 1;
  LevelSink watch = {};              // after the files have got the level; may be empty
  std::function<bool()> stop = {};   // asked before every step, instead of Ctrl-C
  std::function<void()> ready = {};  // called once all is set up, before anything is written
  /// Of the scene; with it check.json tells the case with its defaults, and what follows from them.
  const CaseDocument* document = nullptr;
};

struct RunOutcome {
  RunStatus status = RunStatus::done;
  std::string message;             // of a failure: stage, time, limit; of an inaccurate run: drift, cause
  bool out_of_memory = false;      // is why it failed: no fault of the scene
  std::string warning;             // of a drift of the energy that is less, but more than a thousandth
  std::vector<std::string> notes;  // at the end of a run: what never came on, was held or left behind
  std::vector<SkinLook> looks;     // at the skin, in order
  double wall_seconds = 0.0;
  /// [s] CPU time from the first step to the last, and of each stage; the rest of it are rows and files.
  double cpu_seconds = 0.0;
  std::array<double, kStages> stage_seconds{};
};

/// Called at each field output and at each frame, when the forces of the level stand. May be empty.
struct LevelViews {
  std::function<void(const State&)> fields = {}, frames = {};
  bool skin = false;  // look whether the skin passes through itself, at the levels of docs/results.md
};

/// Steps the scene to its end or to an interrupt, calling `sink` after each step. Failures of the computation
/// (exit code 3) are reported in the outcome, not thrown. `stop` (empty: Ctrl-C) is asked before every step.
RunOutcome run_scene(const Scene& scene, State& state, const LevelSink& sink, const LevelViews& views = {},
                     const Executor& executor = Executor::serial(), const std::function<bool()>& stop = {});

/// Runs and writes history.csv, energy.csv, summary.json, check.json (and frames and fields) to `folder`.
/// `provenance` opens the files; its "run" is the id, by default that of the other lines but the date. Throws
/// OutputError before anything of an earlier run is touched, and as ResultFolder does.
RunOutcome run_to_folder(const Scene& scene, const std::filesystem::path& folder,
                         const Provenance& provenance, const RunOptions& options);

/// "done", "inaccurate", "interrupted" or "failed".
const char* status_name(RunStatus status);
/// Text of summary.json of a run, whatever its outcome.
std::string summary_text(const Scene& scene, const State& state, const RunOutcome& outcome,
                         const Provenance& provenance);
/// The same until the run ends.
std::string summary_of_running(const Scene& scene, const Provenance& provenance);

}  // namespace driver
