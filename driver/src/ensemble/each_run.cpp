// SPDX-License-Identifier: Apache-2.0
#include "ensemble/each_run.hpp"

#include <fmt/format.h>

#include <mutex>

#include "driver/executor.hpp"
#include "driver/progress.hpp"

namespace driver {

void each_run(const std::string& title, int count, int threads, bool quiet,
              const std::function<void(int)>& run) {
  std::mutex lock;
  int finished = 0;
  Progress progress(title, count, quiet);
  Executor(threads).for_each(count, [&](int i) {
    if (interrupted()) return;
    run(i);
    const std::lock_guard<std::mutex> guard(lock);
    ++finished;
    progress.update(finished, [&] { return fmt::format("run {} of {}", finished, count); });
  });
}

}  // namespace driver
