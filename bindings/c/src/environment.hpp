// SPDX-License-Identifier: Apache-2.0
// The floating-point environment of the library: the default, for any traps, rounding and flush to zero of
// the caller. Afterwards the caller's modes and flags are restored.
#pragma once

#include <cfenv>

namespace border {

/// Modes and flags of this thread's floating-point unit. On x86-64 fenv.h takes some 400 ns to change and
/// restore them, more than a short function; the two registers themselves take 20 ns.
class FloatingPoint {
 public:
  static FloatingPoint now() noexcept;
  void set() const noexcept;
  /// No traps, rounding to nearest, denormal numbers kept.
  static void set_default_modes() noexcept;

 private:
#ifdef __x86_64__
  unsigned sse_ = 0;
  unsigned short x87_control_ = 0, x87_status_ = 0;
#else
  std::fenv_t all_{};
#endif
};

/// Lasts as long as a function of the interface.
class Environment {
 public:
  Environment() noexcept : callers_(FloatingPoint::now()) { FloatingPoint::set_default_modes(); }
  ~Environment() { callers_.set(); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

  /// Runs a function of the caller in the caller's environment. It must not throw.
  template <class F>
  auto callers(F&& function) {
    const FloatingPoint ours = FloatingPoint::now();
    callers_.set();
    const auto result = function();
    callers_ = FloatingPoint::now();
    ours.set();
    return result;
  }

 private:
  FloatingPoint callers_;
};

}  // namespace border
