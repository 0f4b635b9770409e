// SPDX-License-Identifier: Apache-2.0
// For a program without threads (cmake/alone).
#include <fmt/format.h>

#include <stdexcept>

#include "base/executor.hpp"

namespace driver {

struct Executor::Arena {};

Executor::Executor(int threads) : threads_(threads) {
  if (threads != 1)
    throw std::invalid_argument(fmt::format("threads: is {}, but this program has 1 thread", threads));
}

Executor::~Executor() = default;

const Executor& Executor::serial() {
  static const Executor one(1);
  return one;
}

void Executor::run(int count, void (*call)(void*, int), void* function) const {
  for (int i = 0; i < count; ++i) call(function, i);
}

}  // namespace driver
