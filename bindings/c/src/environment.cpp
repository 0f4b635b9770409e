// SPDX-License-Identifier: Apache-2.0
#include "environment.hpp"

#ifdef __x86_64__
#include <xmmintrin.h>
#endif

namespace border {

#ifdef __x86_64__
namespace {

constexpr unsigned kSseDefault = 0x1f80;
constexpr unsigned short kX87Default = 0x37f, kX87Flags = 0x3f;

unsigned short x87_status() {
  unsigned short status = 0;
  asm volatile("fnstsw %0" : "=m"(status));
  return status;
}
void set_x87_control(unsigned short control) {
  asm volatile("fldcw %0" : : "m"(control) : "memory");
}

}  // namespace

FloatingPoint FloatingPoint::now() noexcept {
  FloatingPoint point;
  point.sse_ = _mm_getcsr();
  asm volatile("fnstcw %0" : "=m"(point.x87_control_));
  point.x87_status_ = x87_status();
  return point;
}

void FloatingPoint::set() const noexcept {
  if (((x87_status() ^ x87_status_) & kX87Flags) != 0) {  // only long double sets them
    set_x87_control(kX87Default);                         // a flag with its trap on would end the program
    asm volatile("fnclex" : : : "memory");
    const std::fexcept_t flags = x87_status_;
    if ((flags & FE_ALL_EXCEPT) != 0) std::fesetexceptflag(&flags, FE_ALL_EXCEPT);
  }
  set_x87_control(x87_control_);
  _mm_setcsr(sse_);
}

void FloatingPoint::set_default_modes() noexcept {
  set_x87_control(kX87Default);
  _mm_setcsr(kSseDefault);
}

#else

FloatingPoint FloatingPoint::now() noexcept {
  FloatingPoint point;
  std::fegetenv(&point.all_);
  return point;
}

void FloatingPoint::set() const noexcept {
  std::fesetenv(&all_);
}

void FloatingPoint::set_default_modes() noexcept {
  std::fesetenv(FE_DFL_ENV);
}

#endif

}  // namespace border
