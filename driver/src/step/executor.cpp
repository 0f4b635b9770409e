// SPDX-License-Identifier: Apache-2.0
#include "driver/executor.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <stdexcept>

namespace driver {

// The arena alone would stop at the machine's cores.
struct Executor::Arena {
  explicit Arena(int threads)
      : allowed(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)),
        arena(threads) {}
  tbb::global_control allowed;
  tbb::task_arena arena;
};

Executor::Executor(int threads) : threads_(threads) {
  if (threads < 1) throw std::invalid_argument(fmt::format("threads: is {}, 1 or more is allowed", threads));
  if (threads > 1) arena_ = std::make_unique<Arena>(threads);
}

Executor::~Executor() = default;

const Executor& Executor::serial() {
  static const Executor one(1);
  return one;
}

void Executor::run(int count, void (*call)(void*, int), void* function) const {
  arena_->arena.execute([&] { tbb::parallel_for(0, count, [&](int i) { call(function, i); }); });
}

}  // namespace driver
