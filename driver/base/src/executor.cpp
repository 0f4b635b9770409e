// SPDX-License-Identifier: Apache-2.0
#include "base/executor.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <vector>

// ThreadSanitizer does not see how TBB orders its threads, so this file tells it. Only this file is compiled
// without ThreadSanitizer.
#ifdef GASJET_SANITIZE_THREADS
extern "C" void __tsan_acquire(void*);
extern "C" void __tsan_release(void*);
#define GASJET_BEFORE(point) __tsan_release(&(point))
#define GASJET_AFTER(point) __tsan_acquire(&(point))
#else
#define GASJET_BEFORE(point)
#define GASJET_AFTER(point)
#endif

namespace driver {

// By itself the arena would use at most the machine's cores.
struct Executor::Arena {
  explicit Arena(int threads)
      : allowed(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)),
        arena(threads) {}
  tbb::global_control allowed;
  tbb::task_arena arena;
#ifdef GASJET_SANITIZE_THREADS
  char begun{}, ended{};  // their addresses mark the begin and the end of all calls
#endif
};

namespace {

// TBB ends the program if a thread cannot be started, so all are started once beforehand.
void require_threads(int threads) {
  std::mutex mutex;
  std::condition_variable all_tried;
  bool go = false;
  std::vector<std::thread> started;
  const auto end = [&] {
    {
      const std::lock_guard lock(mutex);
      go = true;
    }
    all_tried.notify_all();
    for (std::thread& thread : started) thread.join();
  };
  try {
    while (static_cast<int>(started.size()) < threads - 1)
      started.emplace_back([&] {
        std::unique_lock lock(mutex);
        all_tried.wait(lock, [&] { return go; });
      });
  } catch (const std::system_error&) {
    const std::size_t most = started.size() + 1;
    end();
    throw std::runtime_error(
        fmt::format("threads: is {}, but this system runs only {} (limits of memory or processes): use fewer",
                    threads, most));
  }
  end();
}

}  // namespace

Executor::Executor(int threads) : threads_(threads) {
  if (threads < 1) throw std::invalid_argument(fmt::format("threads: is {}, allowed: 1 or more", threads));
  if (threads == 1) return;
  require_threads(threads);
  arena_ = std::make_unique<Arena>(threads);
}

Executor::~Executor() = default;

const Executor& Executor::serial() {
  static const Executor one(1);
  return one;
}

void Executor::run(int count, void (*call)(void*, int), void* function) const {
  const auto ordered_call = [&](int i) {
    GASJET_AFTER(arena_->begun);
    call(function, i);
    GASJET_BEFORE(arena_->ended);
  };
  GASJET_BEFORE(arena_->begun);
  arena_->arena.execute([&] { tbb::parallel_for(0, count, ordered_call); });
  GASJET_AFTER(arena_->ended);
}

}  // namespace driver
