// SPDX-License-Identifier: Apache-2.0
// From one level to the next, with the rows and views of a run.
#pragma once

#include <functional>
#include <vector>

#include "engine/schedule.hpp"
#include "engine/step.hpp"

namespace driver {

/// Called after every step; `recorded`: the columns (columns.hpp) may be read.
using LevelSink = std::function<void(bool recorded, const State&)>;

/// A view of a run: `show` is called at the levels that are `due`, when their forces stand. `due` is asked
/// once for each level; `last`: the run ends there.
struct LevelView {
  std::function<bool(const State&, bool last)> due;
  std::function<void(const State&)> show;
};

/// A view of the first level at or past each multiple of `interval` [s]; of none if that is 0.
LevelView at_multiples(double interval, std::function<void(const State&)> show);

/// Which levels are recorded.
struct LevelProgress {
  Schedule history;     // as the scene's output asks for them
  StepRequest request;  // of the level
  bool all = false;     // or each of them
};

/// The three parts of a level, to be called in turn.
class LevelLoop {
 public:
  explicit LevelLoop(const Scene& scene) : progress_{Schedule(scene.output.history_every), {}} {}
  /// From the next level on; `sink` may be empty.
  void watch(LevelSink sink, std::vector<LevelView> views);

  /// S2 to S7 of the state's level, and the views that are due; `last`: the run ends there. Throws as
  /// evaluate_level().
  void evaluate(const Scene& scene, State& state, const Executor& executor, bool last);
  /// S8 to S11, and the sink. Throws as advance_level().
  void advance(const Scene& scene, State& state, const Executor& executor);
  /// The same for the last level, of which places and velocities stay: its balance needs a kick, which is no
  /// motion of the scene.
  void complete_last(const Scene& scene, State& state, const Executor& executor);
  /// Makes n+1 the state's level; not after the last one.
  void move_on(const Scene& scene, State& state) const;

  bool recorded() const { return progress_.request.record; }   // the columns of the level may be read
  const LevelProgress& progress() const { return progress_; }  // to go on from
  /// Takes over which levels were recorded.
  void go_on_from(const LevelProgress& progress) { progress_ = progress; }
  /// Records every level from the next one on, or only those that the scene's output asks for.
  void record_all(bool all) { progress_.all = all; }

 private:
  LevelProgress progress_;
  LevelSink sink_;
  std::vector<LevelView> views_;
  std::vector<const LevelView*> due_;  // at the level
};

}  // namespace driver
