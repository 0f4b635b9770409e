// SPDX-License-Identifier: Apache-2.0
// The times of the stages in a run on a machine that others use.
#pragma once

#include <array>
#include <chrono>
#include <ctime>

#include "driver/state.hpp"

namespace driver {

inline constexpr long longest_block = 16;  // steps
/// A block is dropped if this share of its wall time is not CPU time: another program ran in it.
inline constexpr double interrupted_block = 0.05;

/// CPU time of the process [s].
inline double cpu_clock() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Wall time [s].
inline double wall_clock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Time of the stages, in blocks of steps in which no other program took the processor. The CPU clock takes
// longer to read than a short stage to run; the wall clock does not, but counts other programs.
class StageBlocks {
 public:
  StageBlocks(long length, bool one_thread) : length_(length), one_thread_(one_thread) {}

  void update(const State& now) {
    steps_ = now.steps;
    if (++since_ < length_) return;
    since_ = 0;
    const double cpu = cpu_clock(), wall = wall_clock();
    ++readings_;
    const bool quiet = !one_thread_ || wall - wall_ - (cpu - cpu_) < interrupted_block * (wall - wall_);
    if (readings_ > 1 && quiet) {
      levels_ += length_;
      for (std::size_t s = 0; s < kStages; ++s) seconds_[s] += now.stage_seconds[s] - before_[s];
    }
    cpu_ = cpu, wall_ = wall, before_ = now.stage_seconds;
  }

  long steps() const { return steps_; }
  long readings() const { return readings_; }
  long levels() const { return levels_; }
  /// Of the whole run [s].
  double seconds(std::size_t stage) const {
    return seconds_[stage] * static_cast<double>(steps_ + 1) / static_cast<double>(levels_);
  }

 private:
  long length_;
  bool one_thread_;
  long steps_ = 0, since_ = 0, readings_ = 0, levels_ = 0;
  double cpu_ = 0.0, wall_ = 0.0;  // [s] at the end of the last block
  std::array<double, kStages> before_{}, seconds_{};
};

}  // namespace driver
