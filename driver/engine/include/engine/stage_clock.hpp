// SPDX-License-Identifier: Apache-2.0
// CPU time of the stages of a run, on a machine that others use.
#pragma once

#include <array>
#include <ctime>

#include "engine/state.hpp"

namespace driver {

/// CPU time [s] of this thread, or of the whole process.
inline double cpu_seconds(bool of_thread) {
  timespec now{};
  clock_gettime(of_thread ? CLOCK_THREAD_CPUTIME_ID : CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Wall time [s].
inline double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// The run's CPU time, shared out to the stages by their ticks. Those of a block of steps in which another
// program had the processor are left out: CPU time is too slow to read for each stage, ticks count others
// too.
class StageClock {
 public:
  explicit StageClock(bool one_thread) : one_thread_(one_thread) { start_ = at_ = now(); }

  /// After each step.
  void update(const State& state) {
    if (++since_ < block) return;
    since_ = 0;
    close_block(state);
  }
  /// [s] Of each stage, and of all; at the end of the run.
  std::array<double, kStages> seconds(const State& state) {
    close_block(state);
    const Reading shares = quiet_.ticks > 0.0 ? quiet_ : all_;
    std::array<double, kStages> seconds{};
    for (std::size_t s = 0; s < kStages && shares.ticks > 0.0; ++s)
      seconds[s] = total() * shares.stages[s] / shares.ticks;
    return seconds;
  }
  double total() const { return at_.cpu - start_.cpu; }

 private:
  static constexpr int block = 16;             // steps
  static constexpr double interrupted = 0.05;  // share of a block's wall time that is not CPU time

  struct Moment {
    double cpu = 0.0, wall = 0.0;  // [s]
    std::uint64_t ticks = 0;
  };
  struct Reading {
    double ticks = 0.0;
    std::array<double, kStages> stages{};
    void add(double more, const std::array<std::uint64_t, kStages>& now,
             const std::array<std::uint64_t, kStages>& before) {
      ticks += more;
      for (std::size_t s = 0; s < kStages; ++s) stages[s] += static_cast<double>(now[s] - before[s]);
    }
  };

  // All three at one moment: another program may come in between two readings.
  Moment now() const {
    constexpr double at_once = 2e-5;  // [s]
    constexpr int most = 100;
    for (int tries = 1;; ++tries) {
      const double wall = wall_seconds();
      const Moment moment{cpu_seconds(one_thread_), wall, stage_ticks()};
      if (wall_seconds() - wall < at_once || tries == most) return moment;
    }
  }
  void close_block(const State& state) {
    const Moment end = now();
    const double ticks = static_cast<double>(end.ticks - at_.ticks), wall = end.wall - at_.wall;
    all_.add(ticks, state.stage_ticks, before_);
    if (one_thread_ && wall - (end.cpu - at_.cpu) < interrupted * wall)
      quiet_.add(ticks, state.stage_ticks, before_);
    at_ = end;
    before_ = state.stage_ticks;
  }

  bool one_thread_;
  int since_ = 0;
  Moment start_, at_;  // of the run, of the last block
  std::array<std::uint64_t, kStages> before_{};
  Reading all_, quiet_;
};

}  // namespace driver
