// SPDX-License-Identifier: Apache-2.0
#include "engine/stage_clock.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>

namespace driver {

double cpu_seconds(bool of_thread) {
  timespec now{};
  // WebAssembly has no clock of the processor's time.
  if (clock_gettime(of_thread ? CLOCK_THREAD_CPUTIME_ID : CLOCK_PROCESS_CPUTIME_ID, &now) != 0)
    clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::uint64_t stage_ticks() {
#if defined(__x86_64__)
  return __builtin_ia32_rdtsc();
#else
  return static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count());
#endif
}

void CallClock::add(double wall) {
  wall_ += wall;
  pending_ += wall;
  if (pending_ < 1e-3) return;
  known_ = total();
  pending_ = 0.0;
  asked_ = cpu_seconds(threads_ == 1);
}

// Another thread has another clock, on which less time may have passed than none.
double CallClock::total() const {
  const double most = threads_ * pending_, passed = cpu_seconds(threads_ == 1) - asked_;
  return known_ + (passed >= 0.0 ? std::min(passed, most) : most);
}

std::array<double, kStages> StageClock::seconds(const State& state) const {
  const double tick = total() / static_cast<double>(stage_ticks() - start_ticks_);  // [s] of CPU time
  std::array<double, kStages> seconds{};
  for (std::size_t s = 0; s < kStages; ++s) seconds[s] = tick * static_cast<double>(state.stage_ticks[s]);
  return seconds;
}

}  // namespace driver
