// SPDX-License-Identifier: Apache-2.0
// CPU time of a run and of its stages.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>

#include "engine/state.hpp"

namespace driver {

/// CPU time [s] of this thread, or of the whole process.
double cpu_seconds(bool of_thread);

/// Ticks of the processor, of which only shares are used. They take 10 ns to read; CPU time takes 500 ns, and
/// a step has 22 readings.
std::uint64_t stage_ticks();

/// Measures the ticks of a stage, and names the stage for messages while it runs.
class StageTimer {
 public:
  StageTimer(State& state, Stage stage) : state_(state), stage_(stage), start_(stage_ticks()) {
    state.stage = stage;
  }
  ~StageTimer() { state_.stage_ticks[static_cast<std::size_t>(stage_)] += stage_ticks() - start_; }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  State& state_;
  Stage stage_;
  std::uint64_t start_;
};

/// Shares out the CPU time since it was made to the stages, by their ticks. What other programs take of the
/// processor meets each stage in proportion to its time.
class StageClock {
 public:
  explicit StageClock(bool one_thread)
      : one_thread_(one_thread), start_(cpu_seconds(one_thread)), start_ticks_(stage_ticks()) {}

  /// CPU time of all [s].
  double total() const { return cpu_seconds(one_thread_) - start_; }
  /// That of each stage [s].
  std::array<double, kStages> seconds(const State& state) const;

 private:
  bool one_thread_;
  double start_;  // [s]
  std::uint64_t start_ticks_;
};

/// CPU time of calls, of which the caller may make millions. As its clock takes as long as a small step, it
/// is asked once in a millisecond of calls; what the caller works between them counts as theirs, but never
/// more than the calls took.
class CallClock {
 public:
  explicit CallClock(int threads) : threads_(threads), asked_(cpu_seconds(threads == 1)) {}

  /// A call, as long as it lives. What it calls itself counts once.
  class Call {
   public:
    explicit Call(CallClock& clock) : clock_(clock), start_(std::chrono::steady_clock::now()) {
      ++clock.depth_;
    }
    ~Call() {
      if (--clock_.depth_ == 0)
        clock_.add(std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count());
    }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

   private:
    CallClock& clock_;
    std::chrono::steady_clock::time_point start_;
  };

  double wall() const { return wall_; }  // [s] of all calls
  double total() const;                  // [s] CPU time of them

 private:
  void add(double wall);

  int threads_, depth_ = 0;
  double asked_;                                     // [s] what the clock said when it was asked last
  double wall_ = 0.0, known_ = 0.0, pending_ = 0.0;  // [s] known until then; wall time since then
};

}  // namespace driver
