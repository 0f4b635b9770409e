// SPDX-License-Identifier: Apache-2.0
// Four floats at once. min and max are single instructions, which gcc does not find.
#pragma once
#include <algorithm>
#include <array>
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace coupling::detail {

using Four = float __attribute__((vector_size(16)));
typedef float UnalignedFour __attribute__((vector_size(16), aligned(4), may_alias));

inline Four load(const float* p) {
  return *reinterpret_cast<const UnalignedFour*>(p);
}
inline void store(float* p, Four a) {
  *reinterpret_cast<UnalignedFour*>(p) = a;
}
inline Four larger(Four a, Four b) {
#if defined(__SSE__)
  return _mm_max_ps(a, b);
#else
  return a < b ? b : a;
#endif
}
inline Four smaller(Four a, Four b) {
#if defined(__SSE__)
  return _mm_min_ps(a, b);
#else
  return b < a ? b : a;
#endif
}
inline float least_of(Four a) {
  return std::min(std::min(a[0], a[1]), std::min(a[2], a[3]));
}

inline std::array<Four, 4> transposed(const std::array<Four, 4>& a) {
  const Four low01 = __builtin_shufflevector(a[0], a[1], 0, 4, 1, 5),
             low23 = __builtin_shufflevector(a[2], a[3], 0, 4, 1, 5),
             high01 = __builtin_shufflevector(a[0], a[1], 2, 6, 3, 7),
             high23 = __builtin_shufflevector(a[2], a[3], 2, 6, 3, 7);
  return {__builtin_shufflevector(low01, low23, 0, 1, 4, 5),
          __builtin_shufflevector(low01, low23, 2, 3, 6, 7),
          __builtin_shufflevector(high01, high23, 0, 1, 4, 5),
          __builtin_shufflevector(high01, high23, 2, 3, 6, 7)};
}

}  // namespace coupling::detail
