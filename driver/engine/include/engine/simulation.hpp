// SPDX-License-Identifier: Apache-2.0
// A scene that its caller steps.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/level_loop.hpp"
#include "engine/run.hpp"
#include "engine/stage_clock.hpp"

namespace driver {

/// The computation left its domain (exit code 3), now or at an earlier call. What was computed stays.
class SimulationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A value that the caller has set (controls.hpp).
struct Control {
  enum Kind : int { vent, ambient, inflow, outlet, gravity } kind;  // what it sets
  std::size_t part;                                                 // number of the vent, inflator or jet
  std::array<double, 6> value;  // in the order of its function's arguments
};

/// What a simulation is at one moment.
struct Moment {
  /// A change of scene and state.
  using Change = std::function<void(Scene&, State&)>;

  std::shared_ptr<const Scene> given;  // the scene as it was
  std::shared_ptr<const Scene> scene;  // with what the caller has changed
  State state;                         // of the level; forces as last evaluated
  bool evaluated = false;              // true: forces and step are those of the level
  std::vector<Change> later;           // changes for the next level
  std::vector<Control> controls;       // values that were set, the last of each
  std::string failure;                 // of an earlier call; empty: none
  CallClock clock;                     // of the calls
};

/// A run in the hands of its caller, with the bits of run_scene() unless the caller changes something
/// (controls.hpp). A step has two halves: evaluate() finds the forces of the level at `state().time` and the
/// length of the step, step() then moves. A copy is a run of its own; it shares the scene until one of the
/// two changes it, and has no sink and no views. Objects serve one thread at a time.
class Simulation {
 public:
  /// At t = 0. `scene` should be `driven`, so that its balance has the work of what the caller sets. Throws
  /// CaseError as make_state(), std::invalid_argument for threads < 1.
  explicit Simulation(std::shared_ptr<const Scene> scene, int threads = 1);
  Simulation(const Simulation& other);             // see above
  Simulation& operator=(const Simulation& other);  // likewise; sink, views and places of arrays stay
  Simulation(Simulation&&) = default;
  Simulation& operator=(Simulation&&) = default;
  ~Simulation() = default;

  const Moment& now() const { return now_; }                       // all that a copy takes along
  const Scene& scene() const { return *now_.scene; }               // now().scene
  const State& state() const { return now_.state; }                // now().state
  const LevelLoop& loop() const { return loop_; }                  // which levels are recorded
  bool ended() const { return state().time >= scene().time.end; }  // true: the level is the scene's last
  /// Done if the last level is evaluated, failed, else interrupted; with notes, and times of the calls alone.
  RunOutcome outcome() const;

  /// S2 to S7 of the level: gas, forces, length of the step; of the last level its balance and row, too. Does
  /// nothing if that is done. Throws SimulationError.
  void evaluate();
  /// `count` steps >= 0, fewer at the end of the scene. Throws SimulationError, and std::invalid_argument for
  /// a negative number, and for any steps at the end.
  void step(long count = 1);
  /// Steps until the level is at or past `time` [s], or at the end. `stop`, if given, is asked before each
  /// step; true: stops. Throws SimulationError, and std::invalid_argument for a time that is NaN or past.
  void advance(double time, const std::function<bool()>& stop = {});
  /// The same, with steps that meet `time`. Throws in addition if the level is evaluated and its step is too
  /// long.
  void advance_exactly(double time, const std::function<bool()>& stop = {});

  /// Sink and views of this object, from the next evaluation on.
  void watch(LevelSink sink, std::vector<LevelView> views = {});
  /// Lets the columns of every level be read after its step, not only of those with a row; its sink is told
  /// of all of them.
  void record_all(bool all) { loop_.record_all(all); }

  /// Applies a change that S8 to S10 feel: from this level on.
  void change_now(const Moment::Change& change);
  /// Applies a change that S2 to S7 feel: from this level on, or from the next one if this is evaluated.
  void change_level(const Moment::Change& change);
  /// Remembers a value that was set.
  void note(const Control& control);
  /// Back to t = 0 of the scene as it was given; arrays of the state stay at their places.
  void reset();
  /// Goes on from a state of this scene.
  void take(const State& state, const LevelProgress& progress, bool evaluated);

 private:
  void guarded(const std::function<void()>& work);
  void step_once();

  Moment now_;
  LevelLoop loop_;
  std::shared_ptr<const Executor> executor_;
};

}  // namespace driver
