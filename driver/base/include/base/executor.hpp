// SPDX-License-Identifier: Apache-2.0
// Threads of a run, or of a set of runs side by side.
#pragma once

#include <memory>
#include <type_traits>

namespace driver {

/// Calls a function for each number below a count, on up to `threads` threads. The caller must make the
/// results independent of the number of threads: each call writes to its own place, and sums are taken in a
/// fixed order.
class Executor {
 public:
  /// Throws std::invalid_argument if threads < 1.
  explicit Executor(int threads);
  ~Executor();

  /// Executor that uses the calling thread only.
  static const Executor& serial();
  int threads() const { return threads_; }

  /// Calls f(0), ..., f(count - 1), in any order and at the same time. Rethrows the first exception of a
  /// call.
  template <class F>
  void for_each(int count, F&& f) const {
    if (!arena_) {
      for (int i = 0; i < count; ++i) f(i);
      return;
    }
    using Function = std::remove_reference_t<F>;
    run(
        count, [](void* g, int i) { (*static_cast<Function*>(g))(i); },
        const_cast<void*>(static_cast<const void*>(&f)));
  }

 private:
  struct Arena;
  void run(int count, void (*call)(void*, int), void* function) const;  // takes the function without
                                                                        // allocating

  int threads_;
  std::unique_ptr<Arena> arena_;  // null for one thread
};

}  // namespace driver
