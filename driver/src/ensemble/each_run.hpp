// SPDX-License-Identifier: Apache-2.0
// The loop of commands that make many runs.
#pragma once

#include <functional>
#include <string>

namespace driver {

/// Calls `run` with 0 to count - 1, side by side on `threads` and each serial inside, until an interrupt.
void each_run(const std::string& title, int count, int threads, bool quiet,
              const std::function<void(int)>& run);

}  // namespace driver
